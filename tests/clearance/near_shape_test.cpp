// Bounds of distances reject nothing that is near enough: against exact distances, at the limit.
#include <catch2/catch.hpp>

#include <cmath>

#include "flashbvh/clearance.hpp"
#include "property/any_mesh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// A mesh of one triangle, in a leaf that is the root.
AnyMesh mesh_of(const Vertex& p, const Vertex& q, const Vertex& r) {
  bake::LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles = {{0, 1, 2}};
  bake::BuildTree tree = chain(mesh, true);
  return AnyMesh(tree, mesh);
}

Vertex any_vertex(Random& random, std::int32_t reach) {
  const auto at = [&] { return static_cast<std::int16_t>(random.between(-reach, reach)); };
  return {at(), at(), at()};
}

/// A point above the middle of a triangle, `height` off its plane, or beside its longest edge.
Vertex above(const Vertex& p, const Vertex& q, const Vertex& r, double height) {
  const double u[3] = {1.0 * q.x - p.x, 1.0 * q.y - p.y, 1.0 * q.z - p.z};
  const double v[3] = {1.0 * r.x - p.x, 1.0 * r.y - p.y, 1.0 * r.z - p.z};
  const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-9;
  const auto at = [&](int axis, double first) {
    const double value = first + (u[axis] + v[axis]) / 3 + n[axis] / length * height;
    return static_cast<std::int16_t>(std::max(-16383.0, std::min(16383.0, std::round(value))));
  };
  return {at(0, p.x), at(1, p.y), at(2, p.z)};
}

/// The squared distance, rounded up: a limit that the pair is within.
std::int64_t limit_of(const PostMesh& a, const PostMesh& b, const Transform& transform) {
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
void check_leaf(const PostMesh& a, const PostMesh& b, const Transform& transform, Gap gap,
                std::uint32_t& rejected, Gap less) {
  const PackedBox& box_a = a.nodes[0].box;
  const PackedBox& box_b = b.nodes[0].box;
  REQUIRE(gap(box_a, box_b));
  for (const Side side : {Side::a, Side::b}) {
    const PackedBox& other = side == Side::a ? box_b : box_a;
    NearShapes<PostMesh> shapes(a, b, transform);
    shapes.set_bound(gap);
    REQUIRE(shapes.begin(side, 0, &other));
    REQUIRE(shapes.may_touch(other));
    shapes.set_bound(less);
    rejected += shapes.may_touch(other) ? 0 : 1;
  }
}

void check(const PostMesh& a, const PostMesh& b, const Pose& pose, std::uint32_t& rejected) {
  Transform transform(pose, a, b, /*may_stop=*/false);
  transform.bring_near();
  transform.prepare(b);
  const std::int64_t limit = limit_of(a, b, transform);
  // A tenth of the distance less.
  const std::int64_t less = limit / 5 * 4;
  if (transform.is_rotated()) {
    check_leaf(a, b, transform, RotatedGap(transform.rotated(), GapLimit(limit)), rejected,
               RotatedGap(transform.rotated(), GapLimit(less)));
  } else {
    const Point& offset = transform.translated().offset;
    check_leaf(a, b, transform, TranslatedGap(offset, GapLimit(limit)), rejected,
               TranslatedGap(offset, GapLimit(less)));
  }
}

}  // namespace

TEST_CASE("a sum of squared gaps is within a limit if it is") {
  Random random(test_seed());
  for (int round = 0; round < 200000; ++round) {
    CAPTURE(round);
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
  }
}

TEST_CASE("leaves as shapes reject no box that is within the limit") {
  Random random(test_seed());
  std::uint32_t translated = 0;
  std::uint32_t rotated = 0;
  std::uint32_t stretched = 0;
  constexpr std::uint32_t kRounds = 6000;
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    CAPTURE(round);
    const std::int32_t reach = 1 << (3 + random.below(11));
    const Vertex p = any_vertex(random, reach);
    const Vertex q = any_vertex(random, reach);
    const Vertex r = any_vertex(random, reach);
    const std::int32_t height = random.between(0, 16000);
    const Vertex point = above(p, q, r, height);
    const AnyMesh triangle = mesh_of(p, q, r);
    const AnyMesh other = random.below(3) == 0
                              ? mesh_of(any_vertex(random, 16000), any_vertex(random, 16000),
                                        any_vertex(random, 16000))
                              : mesh_of(point, point, point);
    const PostMesh a = (round % 2 == 0 ? triangle : other).view<PostMesh>();
    const PostMesh b = (round % 2 == 0 ? other : triangle).view<PostMesh>();
    const std::int32_t far = random.below(4) == 0 ? 20000 : 0;
    const std::int32_t cells[3] = {random.between(-far, far), random.between(-far, far), 0};
    check(a, b, Pose::translated(cells[0], cells[1], cells[2]), translated);
    Rotation rotation = rotation_of(any_quaternion(random));
    check(a, b, Pose::rigid(rotation.entry, cells), rotated);
    // As far from a rotation as a pose takes.
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
  }
  CHECK(translated > kRounds / 4);
  CHECK(rotated > kRounds / 4);
  CHECK(stretched > kRounds / 8);
}
