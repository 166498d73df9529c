// Boxes under a rotation against the definition in 64-bit integers.
#include <stdint.h>

#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "support/points.hpp"
#include "support/rotations.hpp"
#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr int32_t kMost = kMaxCoordinate;

/// Rounds a biased bound, in 1/kSplitOne cell, down to whole cells, clamped to the lattice.
uint32_t whole_cells(int64_t bound) {
  const int64_t cells = bound >> kSplitBits;
  return static_cast<uint32_t>(cells < 0 ? 0 : cells > 32767 ? 32767 : cells);
}

struct Bounds {
  uint32_t upper, lower;
};

/// A positive entry takes the upper bound, a negative one the lower bound.
Bounds bounds_on(const SplitRow& row, const BoxTestStart& start, const PackedBox& box) {
  const int64_t entries[] = {row.x(), row.y(), row.z_entry()};
  const Bounds of_box[] = {{low_half(box.upper_xy), low_half(box.lower_xy)},
                           {high_half(box.upper_xy), high_half(box.lower_xy)},
                           {low_half(box.z), high_half(box.z)}};
  int64_t upper = start.upper;
  int64_t lower = start.lower;
  for (int i = 0; i < 3; ++i) {
    const bool positive = entries[i] > 0;
    const int64_t magnitude = positive ? entries[i] : -entries[i];
    upper += magnitude * (positive ? of_box[i].upper : of_box[i].lower);
    lower += magnitude * (positive ? of_box[i].lower : of_box[i].upper);
  }
  return {whole_cells(upper), whole_cells(lower)};
}

PackedBox rotated_box(const SplitMatrix& matrix, const BoxTestStart* starts, const PackedBox& box) {
  const Bounds x = bounds_on(matrix.row[0], starts[0], box);
  const Bounds y = bounds_on(matrix.row[1], starts[1], box);
  const Bounds z = bounds_on(matrix.row[2], starts[2], box);
  return {join_halves(x.upper, y.upper), join_halves(x.lower, y.lower),
          join_halves(z.upper, z.lower)};
}

bool overlap(const PackedBox& a, const PackedBox& b) {
  return test::overlap(unpack(a), unpack(b));
}

/// The whole lattice up to a side of `box`, or up to a cell before it: whether it overlaps `box`
/// depends on this bound alone.
PackedBox box_beside(Random& random, const PackedBox& box) {
  const auto axis = kVertexAxes[random.below(3)];
  const Box side = unpack(box);
  Box beside = {{-kMost, -kMost, -kMost}, {kMost, kMost, kMost}};
  const int32_t above = side.upper.*axis + random.between(0, 1);
  const int32_t below = side.lower.*axis - random.between(0, 1);
  const auto on_lattice = [](int32_t cells) { return cells >= -kMost && cells <= kMost; };
  if (random.below(2) == 0 && on_lattice(above)) {
    beside.lower.*axis = static_cast<int16_t>(above);
  } else if (on_lattice(below)) {
    beside.upper.*axis = static_cast<int16_t>(below);
  }
  return pack(beside);
}

/// A random pose with a rotation, and its transform for the largest meshes, at any distance.
struct AnyRotation {
  Pose pose = Pose::translated(0, 0, 0);
  RotatedTransform transform{};

  explicit AnyRotation(Random& random) {
    constexpr int32_t reaches[] = {0, 20, 16383, 50000, kMaxTranslation};
    while (pose.is_translation()) {
      pose = any_rigid_pose(random, random.one_of(reaches));
    }
    const PackedBox all = pack({{-kMost, -kMost, -kMost}, {kMost, kMost, kMost}});
    const int32_t origin[3] = {0, 0, 0};
    REQUIRE(transform.prepare(pose, origin, all, origin, all, /*may_stop=*/false));
  }
};

}  // namespace

TEST_CASE("boxes overlap under a rotation exactly when both rotated boxes do, whatever was kept") {
  int overlaps = 0;
  int gaps = 0;
  for_rounds(1000, 1, [&](Random& random, int) {
    const AnyRotation rotation(random);
    const SplitMatrix& rows = rotation.pose.matrix().rows;
    const SplitMatrix& columns = rotation.transform.columns;
    // Each box next to the other one, rotated; kept boxes are identified by their addresses.
    BoxInNode a[3];
    BoxInNode b[3];
    for (int i = 0; i < 3; ++i) {
      const PackedBox any = pack(any_box(random));
      const PackedBox beside = box_beside(random, rotated_box(rows, rotation.transform.on_a, any));
      const PackedBox rotated = rotated_box(columns, rotation.transform.on_b, beside);
      a[i] = in_node(random, unpack(beside));
      b[i] = in_node(random, unpack(i == 0 ? box_beside(random, rotated) : any));
    }
    RotatedBoxTest test(rotation.transform);
    for (int visit = 0; visit < 20; ++visit) {
      const PackedBox& of_a = a[random.below(3)].box;
      const PackedBox& of_b = b[random.below(3)].box;
      const bool expected = overlap(of_a, rotated_box(rows, rotation.transform.on_a, of_b)) &&
                            overlap(of_b, rotated_box(columns, rotation.transform.on_b, of_a));
      CAPTURE(visit);
      REQUIRE(test(of_a, of_b) == expected);
      ++(expected ? overlaps : gaps);
    }
  });
  CHECK(overlaps > 1000);
  CHECK(gaps > 1000);
}

TEST_CASE("roots are far apart exactly when one, rotated, is next to the other") {
  constexpr int32_t widest = 3 * kMost / 2 + 1 + kSplitOne / 2;
  int near = 0;
  int far = 0;
  int far_on_b = 0;
  for_rounds(20000, 3, [&](Random& random, int) {
    const AnyRotation rotation(random);
    const RotationMatrix& matrix = rotation.pose.matrix();
    BoxTestStart starts[3];
    for (int i = 0; i < 3; ++i) {
      const int32_t offset = offset_of(rotation.transform.on_a[i]);
      const int32_t shared = (kSplitOne - matrix.rows.row[i].sum()) * kBoundBias + widest;
      starts[i] = {shared + offset, shared - offset};
    }
    const PackedBox b = pack(any_box(random));
    const PackedBox rotated = rotated_box(matrix.rows, starts, b);
    const PackedBox a = random.below(4) == 0 ? pack(any_box(random)) : box_beside(random, rotated);
    const int32_t origin[3] = {0, 0, 0};
    RotatedTransform transform{};
    REQUIRE(transform.prepare(rotation.pose, origin, a, origin, b, /*may_stop=*/false));
    const bool on_a = overlap(a, rotated);
    const bool expected = on_a && overlap(b, rotated_box(transform.columns, transform.on_b, a));
    far_on_b += on_a && !expected ? 1 : 0;
    REQUIRE(transform.prepare(rotation.pose, origin, a, origin, b, /*may_stop=*/true) == expected);
    ++(expected ? near : far);
  });
  CHECK(near > 2000);
  CHECK(far > 2000);
  CHECK(far_on_b > 200);
}

TEST_CASE("B's origin lies where a sum of 64 bits says, near or far") {
  constexpr int32_t reaches[] = {0, 20, 32768, 32769, 100000, 1 << 29};
  constexpr int64_t most = int64_t{kMaxOffset} * kSplitOne;
  const PackedBox all = pack({{-kMost, -kMost, -kMost}, {kMost, kMost, kMost}});
  int within = 0;
  int clamped = 0;
  for_rounds(5000, 4, [&](Random& random, int) {
    Pose pose = Pose::translated(0, 0, 0);
    while (pose.is_translation()) {
      pose = any_rigid_pose(random, random.one_of(reaches));
    }
    // A random coordinate, or one at an end.
    const auto coordinate = [&](int32_t reach) {
      const int32_t any = random.between(-reach, reach);
      return random.below(4) != 0 ? any : any < 0 ? -reach : reach - 1;
    };
    const int32_t reach_a = random.one_of(reaches);
    const int32_t reach_b = random.one_of(reaches);
    const int32_t a[] = {coordinate(reach_a), coordinate(reach_a), coordinate(reach_a)};
    const int32_t b[] = {coordinate(reach_b), coordinate(reach_b), coordinate(reach_b)};
    RotatedTransform transform{};
    REQUIRE(transform.prepare(pose, a, all, b, all, /*may_stop=*/false));
    for (int i = 0; i < 3; ++i) {
      int32_t row[3] = {};
      pose.matrix().get_row(i, row[0], row[1], row[2]);
      int64_t sum = int64_t{pose.translation(i) - a[i]} * (1 << kRotationBits) +
                    int64_t{pose.fraction(i)} * (1 << (kRotationBits - 16)) +
                    (1 << (kRestBits - 1));
      for (int j = 0; j < 3; ++j) {
        sum += int64_t{row[j]} * b[j];
      }
      const int64_t offset = sum >> kRestBits;
      CAPTURE(i, offset);
      REQUIRE(offset_of(transform.on_a[i]) == (offset < -most  ? -most
                                               : offset > most ? most
                                                               : offset));
      ++(offset < -most || offset > most ? clamped : within);
    }
  });
  CHECK(within > 2000);
  CHECK(clamped > 2000);
}
