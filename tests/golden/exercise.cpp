#include "golden/exercise.hpp"

#include <cstring>
#include <memory>

#include "bake/made_levels.hpp"
#include "flashbvh/image.hpp"
#include "golden/golden.hpp"
#include "support/any_query.hpp"
#include "support/most_work.hpp"
#include "support/rotations.hpp"
#include "support/same_view.hpp"

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
    // Once with a suspension.
    Status status = query.run(most / 512, sink).status;
    status = status == Status::suspended ? query.run(most, sink).status : status;
    const QueryStats& counts = query.stats();
    if (status != Status::done || counts.visits > most_visits_of_nodes(a, b) ||
        counts.overlaps > counts.visits || counts.leaf_pairs > counts.overlaps ||
        reported != counts.triangle_pairs) {
      wrong = name;
    }
  });
  return wrong;
}

template <class Tree>
using Levels = std::vector<typename Tree::Index>;

/// Opens the smallest golden image of this kind; false if there is none.
template <class Tree>
bool open_partner(Tree& partner, Levels<Tree>& levels) {
  const auto opens = [&](const KeptImage& image) {
    return open_levelled(image.bytes, image.size, partner, levels) == Status::done;
  };
  const KeptImage* smallest = nullptr;
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    const KeptImage& image = kKeptImages[i];
    if (opens(image) && partner.node_count > 1 &&
        (smallest == nullptr || image.size < smallest->size)) {
      smallest = &image;
    }
  }
  return smallest != nullptr && opens(*smallest);
}

template <class Tree>
void open_and_exercise(const void* bytes, std::size_t size, const std::vector<Pose>& poses,
                       Verdict& verdict) {
  Tree tree;
  Levels<Tree> levels;
  if (open_levelled(bytes, size, tree, levels) != Status::done) {
    return;
  }
  verdict.opened = true;
  using Seen = BasicMesh<typename Tree::Index, Tree::kLayout>;
  if (!same_view<typename Tree::Index, Tree::kLayout>(tree, view_unchecked<Seen>(bytes))) {
    verdict.wrong = "a view without a check is another one";
  }
  if (poses.empty()) {
    return;
  }
  Tree partner;
  Levels<Tree> partner_levels;
  if (!open_partner(partner, partner_levels)) {
    verdict.wrong = "there is no golden image of this kind";
    return;
  }
  partner.cell_bits = tree.cell_bits;
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
  open_and_exercise<PreMeshWithLevels>(block.get(), size, poses, verdict);
  open_and_exercise<MeshWithLevels>(block.get(), size, poses, verdict);
  open_and_exercise<PreMeshWithLevels32>(block.get(), size, poses, verdict);
  open_and_exercise<MeshWithLevels32>(block.get(), size, poses, verdict);
  return verdict;
}

void repair_crc(void* bytes, std::size_t size) {
  if (size >= sizeof(ImageHeader)) {
    const std::uint32_t crc = image_crc(bytes, size);
    std::memcpy(static_cast<unsigned char*>(bytes) + offsetof(ImageHeader, crc), &crc, sizeof crc);
  }
}

std::vector<Pose> representative_poses() {
  const auto rotated = [](const Quaternion& q, std::int32_t x, std::int32_t y, std::int32_t z) {
    return Pose::rigid(rotation_of(q).entry, {x, y, z}, {-32768, 32767, 1});
  };
  return {Pose::translated(7, -3, 2), rotated({700, 300, -200, 100}, 20, -10, 5),
          rotated({1, 0, 1, 0}, -kMaxTranslation, kMaxTranslation, -kMaxTranslation),
          rotated({1, 2, 3, 4}, INT32_MIN, INT32_MAX, INT32_MIN)};
}

}  // namespace flashbvh::test
