// Gaps of boxes in each form, against gaps axis by axis.
#include "flashbvh/clearance.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

/// A mesh of one triangle, whose leaf is the root.
AnyMesh mesh_of(const Vertex& p, const Vertex& q, const Vertex& r) {
  bake::LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles = {{0, 1, 2}};
  return AnyMesh(chain(mesh, true), mesh);
}

/// The upper bound of a box along a row, in whole cells.
std::int32_t rotated_bound(const SplitRow& row, std::int64_t start, const std::uint32_t (&upper)[3],
                           const std::uint32_t (&lower)[3]) {
  const std::int32_t entry[3] = {row.x(), row.y(), row.z_entry()};
  for (int i = 0; i < 3; ++i) {
    start += std::int64_t{std::abs(entry[i])} * (entry[i] < 0 ? lower[i] : upper[i]);
  }
  return static_cast<std::int32_t>(start >> kSplitBits);
}

void check_seen(const SeenBox& seen, const SplitMatrix& matrix, const BoxTestStart* starts,
                std::int32_t rounding, const PackedBox& box) {
  const std::uint32_t upper[3] = {low_half(box.upper_xy), high_half(box.upper_xy), low_half(box.z)};
  const std::uint32_t lower[3] = {low_half(box.lower_xy), high_half(box.lower_xy),
                                  high_half(box.z)};
  for (int i = 0; i < 3; ++i) {
    const SplitRow& row = matrix.row[i];
    REQUIRE(seen.upper[i] ==
            rotated_bound(row, std::int64_t{starts[i].upper} + rounding, upper, lower));
    REQUIRE(seen.lower[i] ==
            rotated_bound(row, std::int64_t{starts[i].lower} + rounding, lower, upper));
  }
}

/// A random box, large or small.
Box sized_box(Random& random) {
  const Vertex p = any_vertex(random, kMaxCoordinate);
  const std::int32_t size = 1 << random.below(15);
  return box_around(p, {coordinate_near(random, p.x, size), coordinate_near(random, p.y, size),
                        coordinate_near(random, p.z, size)});
}

}  // namespace

TEST_CASE("gaps of boxes are those along each axis, however many are worked out at once") {
  std::uint32_t near = 0;
  const auto tries = rounds(7000u, 20000u);
  for_rounds(tries, [&](Random& random, std::uint32_t round) {
    const GapLimit limit(std::int64_t{1} << random.below(35));
    const PackedBox a = pack(sized_box(random));
    const PackedBox b = pack(sized_box(random));
    const std::int32_t most = round % 2 == 0 ? kMaxOffset : 20'000;
    const Point offset = any_point(random, most);
    const SeenBox seen = seen_translated(b, offset);
    REQUIRE(squared_gap(seen, a, limit) == squared_gap_by_axis(seen, a, limit));
    REQUIRE(WideGap(offset, limit).squared(a, b) == squared_gap_by_axis(seen, a, limit));
    // At the exact gap, and next to it.
    const std::int64_t squared = WideGap(offset, GapLimit(0)).squared(a, b);
    for (std::int64_t by = -1; by <= 1; ++by) {
      const GapLimit beside(squared + by);
      if (squared + by >= 0 && TranslatedGap::fit(offset, beside)) {
        REQUIRE(TranslatedGap(offset, beside)(a, b) == WideGap(offset, beside)(a, b));
        REQUIRE(TranslatedGap(offset, beside)(a, b) == (by >= 0));
        ++near;
      }
    }
  });
  CHECK(near > tries / 2);
}

TEST_CASE("rotated boxes are the sums of products along each axis") {
  for_rounds(rounds(1500, 5000), [&](Random& random, int) {
    const Vertex of_a[] = {any_vertex(random, 16383), any_vertex(random, 16383)};
    const Vertex of_b[] = {any_vertex(random, 16383), any_vertex(random, 16383)};
    const AnyMesh a = mesh_of(of_a[0], of_a[1], {0, 0, 0});
    const AnyMesh b = mesh_of(of_b[0], of_b[1], {0, 0, 0});
    const Pose pose = any_rigid_pose(random, 40000);
    Transform transform(pose, a, b, /*may_stop=*/false);
    if (!transform.is_rotated()) {
      return;
    }
    const RotatedTransform& rotated = transform.rotated();
    RotatedGap gap(rotated, GapLimit(1 << 20));
    const PackedBox& box_a = a.nodes[0].box;
    const PackedBox& box_b = b.nodes[0].box;
    check_seen(gap.seen_of_b(box_b), rotated.matrix->rows, rotated.on_a, 0, box_b);
    check_seen(gap.seen_of_a(box_a), rotated.columns, rotated.on_b, kSplitOne - 1, box_a);
    const std::int64_t squared = RotatedGap(rotated, GapLimit(0)).squared(box_a, box_b);
    for (std::int64_t by = -1; by <= 1; ++by) {
      const GapLimit beside(std::max<std::int64_t>(squared + by, 0));
      RotatedGap wide(rotated, beside);
      KeptGap kept(transform, beside);
      REQUIRE(kept(box_a, box_b) == wide(box_a, box_b));
      REQUIRE(kept(box_a, box_b) == wide(box_a, box_b));  // with the kept box
    }
  });
}

TEST_CASE("a sum of squared gaps is within a limit if it is") {
  for_rounds(rounds(40000, 200000), [&](Random& random, int) {
    const std::int32_t most = 1 << random.below(17);
    const std::int64_t gap[3] = {random.between(0, most), random.between(0, most),
                                 random.between(0, most / 8)};
    const std::int64_t sum = gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2];
    const auto passes = [&](std::int64_t squared) {
      const GapLimit limit(squared);
      std::uint32_t all = 0;
      for (const std::int64_t g : gap) {
        all += limit.squared(static_cast<std::int32_t>(g));
      }
      return all <= limit.limit();
    };
    REQUIRE(passes(sum));
    REQUIRE(passes(sum + random.between(0, 1 << 20)));
    if (sum > 0 && sum < std::int64_t{1} << 30) {
      REQUIRE_FALSE(passes(sum - 1));
    } else if (sum > 0) {
      // In quarters, rounded down: four cells along each axis.
      REQUIRE_FALSE(passes(sum - 24 * (gap[0] + gap[1] + gap[2]) - 1000));
    }
    const GapLimit limit(sum);
    REQUIRE(limit.longer_limit() >= limit.limit());
    REQUIRE(limit.sum_limit() >= limit.limit());
  });
}
