#include "golden/exercise.hpp"

#include <cstring>
#include <memory>

#include "flashbvh/detail/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "golden/golden.hpp"
#include "support/any_query.hpp"
#include "support/most_work.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {
namespace {

template <class Tree>
const char* exercise(const Tree& a, const Tree& b, const Pose& pose) {
  const char* wrong = nullptr;
  const std::uint32_t most = most_work_of_nodes(a, b);
  for_each_query(a, b, pose, [&](const char* name, auto& query) {
    if (query.status() != Status::suspended) {
      wrong = pose.status() == Status::done && a.cell_bits == b.cell_bits ? name : wrong;
      return;
    }
    std::uint32_t reported = 0;
    const auto sink = [&](const TrianglePair<typename Tree::Index>&) {
      ++reported;
      return true;
    };
    // Once with a stop on the way.
    Status status = query.run(most / 512, sink);
    status = status == Status::suspended ? query.run(most, sink) : status;
    const Counts& counts = query.counts();
    if (status != Status::done || counts.visits > most_visits_of_nodes(a, b) ||
        counts.overlaps > counts.visits || counts.leaf_pairs > counts.overlaps ||
        reported != counts.triangle_pairs) {
      wrong = name;
    }
  });
  return wrong;
}

/// The smallest golden image of this kind, with the cell of another tree.
template <class Tree>
Tree partner_of(const Tree& other) {
  Tree smallest{};
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    Tree tree;
    if (open_image(kKeptImages[i].bytes, kKeptImages[i].size, tree) == Status::done &&
        tree.node_count > 1 &&
        (smallest.nodes == nullptr || tree.node_count < smallest.node_count)) {
      smallest = tree;
    }
  }
  smallest.cell_bits = other.cell_bits;
  return smallest;
}

template <class Tree>
void open_and_exercise(const void* bytes, std::size_t size, const std::vector<Pose>& poses,
                       Verdict& verdict) {
  Tree tree;
  if (open_image(bytes, size, tree) != Status::done) {
    return;
  }
  verdict.opened = true;
  if (poses.empty()) {
    return;
  }
  const Tree partner = partner_of(tree);
  if (partner.nodes == nullptr) {
    verdict.wrong = "there is no golden image of this kind";
    return;
  }
  for (const Pose& pose : poses) {
    for (const char* wrong : {exercise(tree, tree, pose), exercise(tree, partner, pose),
                              exercise(partner, tree, pose)}) {
      verdict.wrong = wrong != nullptr ? wrong : verdict.wrong;
    }
  }
}

}  // namespace

Verdict exercise_image(const void* bytes, std::size_t size, const std::vector<Pose>& poses) {
  // operator new aligns for any type.
  const std::unique_ptr<unsigned char[]> block(new unsigned char[size]);
  if (size != 0) {
    std::memcpy(block.get(), bytes, size);
  }
  Verdict verdict;
  open_and_exercise<LevelledPreMesh>(block.get(), size, poses, verdict);
  open_and_exercise<LevelledPostMesh>(block.get(), size, poses, verdict);
  open_and_exercise<LargeLevelledPreMesh>(block.get(), size, poses, verdict);
  open_and_exercise<LargeLevelledPostMesh>(block.get(), size, poses, verdict);
  return verdict;
}

void repair_crc(void* bytes, std::size_t size) {
  if (size >= sizeof(ImageHeader)) {
    const std::uint32_t crc = detail::image_crc(bytes, size);
    std::memcpy(static_cast<unsigned char*>(bytes) + offsetof(ImageHeader, crc), &crc, sizeof crc);
  }
}

std::vector<Pose> telling_poses() {
  const auto rotated = [](const Quaternion& q, std::int32_t x, std::int32_t y, std::int32_t z) {
    return Pose::rigid(rotation_of(q).entry, {x, y, z}, {-32768, 32767, 1});
  };
  return {Pose::translated(7, -3, 2), rotated({700, 300, -200, 100}, 20, -10, 5),
          rotated({1, 0, 1, 0}, -kMaxTranslation, kMaxTranslation, -kMaxTranslation),
          rotated({1, 2, 3, 4}, INT32_MIN, INT32_MAX, INT32_MIN)};
}

}  // namespace flashbvh::test
