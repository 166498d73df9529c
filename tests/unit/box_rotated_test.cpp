// The box test under rotation in this core's form, against its definition in plain integers.
#include <catch2/catch.hpp>

#include "flashbvh/box_rotated.hpp"
#include "support/box_in_node.hpp"
#include "support/random.hpp"
#include "support/rotations.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

struct Bounds {
  std::int32_t upper[3];  ///< biased, in cells
  std::int32_t lower[3];  ///< the same, negated
};

Bounds bounds_of(const PackedBox& box) {
  const auto half = [](std::uint32_t value) { return static_cast<std::int32_t>(value); };
  return {{half(low_half(box.upper_xy)), half(high_half(box.upper_xy)), half(low_half(box.z))},
          {half(low_half(box.lower_xy)), half(high_half(box.lower_xy)), half(high_half(box.z))}};
}

std::int32_t whole_cells(std::int64_t bound) {
  const std::int64_t cells = bound >> kSplitBits;
  return static_cast<std::int32_t>(cells < 0 ? 0 : cells > 0x7FFF ? 0x7FFF : cells);
}

/// Whether `box`, turned, overlaps `other` along the axes of other's lattice.
bool turned_overlaps(const SplitMatrix& matrix, const BoundStart (&starts)[3], const PackedBox& box,
                     const PackedBox& other) {
  const Bounds from = bounds_of(box);
  const Bounds to = bounds_of(other);
  for (int i = 0; i < 3; ++i) {
    const std::int32_t row[3] = {matrix.row[i].x(), matrix.row[i].y(), matrix.row[i].z_entry()};
    std::int64_t upper = starts[i].upper;
    std::int64_t lower = starts[i].lower;
    for (int j = 0; j < 3; ++j) {
      const bool positive = row[j] >= 0;
      const std::int64_t size = positive ? row[j] : -row[j];
      upper += size * (positive ? from.upper[j] : from.lower[j]);
      lower += size * (positive ? from.lower[j] : from.upper[j]);
    }
    if (whole_cells(upper) + to.lower[i] < 2 * kBoundBias ||
        whole_cells(lower) + to.upper[i] < 2 * kBoundBias) {
      return false;
    }
  }
  return true;
}

/// A box that any of its bounds may put at the lattice's end.
BoxInNode any_box(Random& random, std::int32_t most) {
  const auto interval = [&](std::int16_t& low, std::int16_t& high) {
    const std::int32_t size = random.below(4) == 0 ? 0 : random.between(0, 2 * most);
    const std::int32_t at = random.between(-most, most - size);
    low = static_cast<std::int16_t>(at);
    high = static_cast<std::int16_t>(at + size);
  };
  Box box{};
  interval(box.lower.x, box.upper.x);
  interval(box.lower.y, box.upper.y);
  interval(box.lower.z, box.upper.z);
  return in_node(random, box);
}

}  // namespace

TEST_CASE("boxes under rotation overlap exactly when the definition says so") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed);
  const PackedBox everything = pack({{-16383, -16383, -16383}, {16383, 16383, 16383}});
  const std::int32_t nowhere[3] = {0, 0, 0};
  int overlaps = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::int32_t most = round % 2 == 0 ? 16383 : 300;
    const Pose pose = any_rigid_pose(random, random.below(8) == 0 ? 100000 : most);
    if (pose.is_translation()) {
      continue;
    }
    RotatedPlacement placement{};
    REQUIRE(placement.prepare(pose, nowhere, everything, nowhere, everything, false));
    BoxInNode a[4];
    BoxInNode b[4];
    for (int i = 0; i < 4; ++i) {
      a[i] = any_box(random, most);
      b[i] = any_box(random, most);
    }
    RotatedOverlap test(placement);
    // Boxes at hand from before, one of them or none.
    for (int step = 0; step < 24; ++step) {
      const PackedBox& of_a = a[random.below(4)].box;
      const PackedBox& of_b = b[random.below(4)].box;
      const bool expected = turned_overlaps(pose.rows(), placement.on_a, of_b, of_a) &&
                            turned_overlaps(pose.columns(), placement.on_b, of_a, of_b);
      const bool answer = test.overlap(of_a, of_b);
      overlaps += expected ? 1 : 0;
      if (answer != expected) {
        CAPTURE(round, step);
        REQUIRE(answer == expected);
      }
    }
  }
  CHECK(overlaps > 3000);
}
