// Bounds of distances reject no pair within the limit: against exact distances, at the limit.
#include "flashbvh/clearance.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"
#include "support/vectors.hpp"

using namespace flashbvh::detail;

namespace {

/// A mesh of one triangle, whose leaf is the root.
AnyMesh mesh_of(const Vertex& p, const Vertex& q, const Vertex& r) {
  bake::LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles = {{0, 1, 2}};
  return AnyMesh(chain(mesh, true), mesh);
}

/// A point above the middle of a triangle, `height` off its plane, or next to its longest edge.
Vertex above(const Vertex& p, const Vertex& q, const Vertex& r, double height) {
  const FloatVector corner = vector_of<double>(p);
  const FloatVector u = minus(vector_of<double>(q), corner);
  const FloatVector v = minus(vector_of<double>(r), corner);
  const FloatVector n = cross(u, v);
  const FloatVector middle = plus(plus(corner, 1.0 / 3, u), 1.0 / 3, v);
  const FloatVector point = plus(middle, height / (length_of(n) + 1e-9), n);
  const auto at = [&](std::size_t axis) {
    return static_cast<std::int16_t>(
        std::lround(std::clamp<double>(point[axis], -kMaxCoordinate, kMaxCoordinate)));
  };
  return {at(0), at(1), at(2)};
}

/// The pair's squared distance, rounded up: a limit that the pair is within.
std::int64_t limit_of(const Mesh& a, const Mesh& b, const Transform& transform) {
  Triangle of_a;
  Triangle of_b;
  translate_triangle(a, 0, kNoOffset, of_a);
  transform_triangle(b, 0, transform, of_b);
  Fraction squared = kInfinite;
  Features features{};
  REQUIRE(is_nearer(of_a, of_b, squared, features));
  return largest_below(squared, 0) + 1;
}

template <class Gap>
void check_leaf(const Mesh& a, const Mesh& b, const Transform& transform, Gap gap,
                std::uint32_t& rejected, Gap less) {
  const PackedBox& box_a = a.nodes[0].box;
  const PackedBox& box_b = b.nodes[0].box;
  REQUIRE(gap(box_a, box_b));
  for (const Side side : {Side::a, Side::b}) {
    const PackedBox& other = side == Side::a ? box_b : box_a;
    ProximityPlanes<Mesh> shapes(a, b, transform);
    shapes.set_box_test(gap);
    REQUIRE(shapes.begin(side, 0, &other));
    REQUIRE(shapes.may_touch(other));
    shapes.set_box_test(less);
    rejected += shapes.may_touch(other) ? 0 : 1;
  }
}

void check(const Mesh& a, const Mesh& b, const Pose& pose, std::uint32_t& rejected) {
  Transform transform(pose, a, b, /*may_stop=*/false);
  transform.bring_near();
  transform.prepare(b);
  const std::int64_t limit = limit_of(a, b, transform);
  // The limit for a distance smaller by a tenth.
  const std::int64_t less = limit / 5 * 4;
  check_leaf(a, b, transform, KeptGap(transform, GapLimit(limit)), rejected,
             KeptGap(transform, GapLimit(less)));
  if (!KeptGap::is_for(transform, GapLimit(limit))) {
    const Point& offset = transform.translated().offset;
    std::uint32_t again = 0;
    check_leaf(a, b, transform, TranslatedGap(offset, GapLimit(limit)), again,
               TranslatedGap(offset, GapLimit(less)));
  }
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

TEST_CASE("leaves as shapes reject no box that is within the limit") {
  std::uint32_t translated = 0;
  std::uint32_t rotated = 0;
  std::uint32_t stretched = 0;
  const auto tries = rounds(2000u, 6000u);
  for_rounds(tries, [&](Random& random, std::uint32_t round) {
    const std::int32_t reach = 1 << (3 + random.below(11));
    const Vertex p = any_vertex(random, reach);
    const Vertex q = any_vertex(random, reach);
    const Vertex r = any_vertex(random, reach);
    const std::int32_t height = random.between(0, 16000);
    const Vertex point = above(p, q, r, height);
    const AnyMesh triangle = mesh_of(p, q, r);
    Vertex others[] = {point, point, point};
    if (random.below(3) == 0) {
      for (Vertex& vertex : others) {
        vertex = any_vertex(random, 16000);
      }
    }
    const AnyMesh other = mesh_of(others[0], others[1], others[2]);
    const Mesh& a = round % 2 == 0 ? triangle : other;
    const Mesh& b = round % 2 == 0 ? other : triangle;
    const std::int32_t far = random.below(4) == 0 ? 20000 : 0;
    const std::int32_t cells[3] = {random.between(-far, far), random.between(-far, far), 0};
    check(a, b, Pose::translated(cells[0], cells[1], cells[2]), translated);
    Rotation rotation = rotation_of(any_quaternion(random));
    check(a, b, Pose::rigid(rotation.entry, cells), rotated);
    // As far from a rotation as a pose accepts.
    for (auto& row : rotation.entry) {
      for (std::int32_t& entry : row) {
        entry += (random.below(8) == 0 ? -1 : 1) * (entry / 17000);
      }
    }
    const Pose coarse = Pose::rigid(rotation.entry, cells);
    if (coarse.status() == Status::done) {
      check(a, b, coarse, rotated);
      ++stretched;
    }
  });
  CHECK(translated > tries / 4);
  CHECK(rotated > tries / 4);
  CHECK(stretched > tries / 8);
}
