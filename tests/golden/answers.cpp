#include <algorithm>
#include <utility>

#include "golden/golden.hpp"
#include "support/any_query.hpp"
#include "support/opened.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {
namespace {

struct NamedPose {
  const char* name;
  Pose pose;
};

std::vector<NamedPose> poses() {
  const auto rotated = [](const Quaternion& q, std::int32_t x, std::int32_t y, std::int32_t z) {
    return Pose::rigid(rotation_of(q).entry, {x, y, z}, {12345, -23456, 1});
  };
  return {{"translated", Pose::translated(310, 120, 75)},
          {"translated-disjoint", Pose::translated(0, 0, 40000)},
          {"rotated", rotated({700, 300, -200, 100}, 290, 60, -150)},
          {"rotated-quarter", rotated({1, 1, 0, 0}, -120, 330, 40)},
          {"rotated-disjoint", rotated({5, 1, 2, 3}, 40000, 40000, 40000)}};
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::string text_of(const Pairs& pairs) {
  std::string text = "  pairs";
  for (const auto& [a, b] : pairs) {
    text += " " + std::to_string(a) + ":" + std::to_string(b);
  }
  return text + "\n";
}

/// Names as in answers.txt: a traversal has one name for both layouts.
constexpr const char* kTraversals[] = {"leaf",         "stackless",         "ranked",
                                       "volume-stack", "alternating-stack", "ranked-stack"};

/// The answer of one query by one traversal. Writes the pairs if they differ from the last ones, so
/// only for the first traversal.
template <class Query>
std::string answer_of(const char* traversal, Query& query, std::string& last_pairs) {
  Pairs pairs;
  const Status status = query
                            .run(UINT32_MAX,
                                 [&](const typename Query::Pair& pair) {
                                   pairs.emplace_back(pair.a, pair.b);
                                   return true;
                                 })
                            .status;
  std::sort(pairs.begin(), pairs.end());
  const std::string found = text_of(pairs);
  std::string text = found != last_pairs ? found : "";
  last_pairs = found;
  const QueryStats& counts = query.stats();
  text += std::string("  ") + traversal;
  for (const std::uint32_t count :
       {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs}) {
    text += " " + std::to_string(count);
  }
  return text + (status == Status::done ? "\n" : " not done\n");
}

template <class Tree>
std::string answer(const Tree& a, const Tree& b, const Pose& pose) {
  std::string text;
  std::string last_pairs;
  for (const char* const traversal : kTraversals) {
    for_each_query(a, b, pose, [&](const std::string& name, auto& query) {
      if (name == traversal || name == std::string(traversal) + "-post") {
        text += answer_of(traversal, query, last_pairs);
      }
    });
  }
  return text;
}

/// Empty if the two images are not of this kind.
template <class Tree>
std::string answers_between(const KeptImage& a, const KeptImage& b) {
  Opened<Tree> opened_a;
  Opened<Tree> opened_b;
  std::string text;
  if (opened_a.open(a.bytes, a.size) && opened_b.open(b.bytes, b.size)) {
    for (const NamedPose& named : poses()) {
      text += std::string(a.name) + " " + b.name + " " + named.name + "\n" +
              answer(opened_a.mesh, opened_b.mesh, named.pose);
    }
  }
  return text;
}

}  // namespace

std::string answers_of(const KeptImage* images, std::size_t count) {
  std::string text =
      "# A, B, B's pose; pairs of triangles; by each traversal: visits, overlaps, pairs of\n"
      "# leaves, pairs of triangles. Written by write_golden.\n";
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      text += answers_between<MeshWithLevels>(images[i], images[j]);
      text += answers_between<PreMeshWithLevels>(images[i], images[j]);
      text += answers_between<MeshWithLevels32>(images[i], images[j]);
      text += answers_between<PreMeshWithLevels32>(images[i], images[j]);
    }
  }
  return text;
}

}  // namespace flashbvh::test
