// Meshes beyond the range of exact distances: all reported bounds hold.
#include "flashbvh/clearance.hpp"
#include "support/all_distances.hpp"
#include "support/any_mesh.hpp"
#include "support/boxes.hpp"
#include "support/test.hpp"

namespace {

constexpr std::int32_t kRange = 1 << 20;

using Found = Clearance<std::uint16_t>;

/// A hollow box of the largest size.
bake::LatticeMesh largest_box() {
  bake::LatticeMesh mesh;
  add_box(mesh, {-16383, -16383, -16383}, {32766, 32766, 32766}, false);
  return mesh;
}

bake::LatticeMesh doubled(bake::LatticeMesh mesh) {
  for (Vertex& v : mesh.vertices) {
    v = vertex_of({2 * v.x, 2 * v.y, 2 * v.z});
  }
  return mesh;
}

bool is_zero(const FinePoint& p) {
  return p.x == 0 && p.y == 0 && p.z == 0;
}

/// The answer has no triangles or points, and its bounds hold; vertices are off by `rounded` cells.
void check_bounds(const Found& found, double truth, double rounded) {
  CAPTURE(truth, found.lower / 256.0, found.upper / 256.0);
  REQUIRE(found.status == Status::done);
  REQUIRE_FALSE(found.in_range);
  REQUIRE(found.lower > 0);
  REQUIRE(found.lower / 256.0 <= truth + rounded);
  REQUIRE(found.upper / 256.0 >= truth - rounded);
  REQUIRE(found.triangles.a + found.triangles.b == 0);
  REQUIRE(found.witness.is_none());
  REQUIRE((is_zero(found.point_a) && is_zero(found.point_b)));
  REQUIRE((found.direction.x | found.direction.y | found.direction.z) == 0);
}

}  // namespace

TEST_CASE("of two hollow boxes of the largest size, half their size apart, both bounds hold") {
  Random random = test_random();
  const AnyMesh mesh = any_mesh(random, largest_box());
  for (const std::int32_t x : {kRange, kRange + 1, kRange + 60000, kRange + (1 << 22)}) {
    // Face to face, edge to edge, corner to corner.
    for (const int axes : {1, 2, 3}) {
      const std::int32_t cells[3] = {x, axes > 1 ? -x : 0, axes > 2 ? x : 0};
      const double truth = std::sqrt(axes) * (x - 2 * 16383);
      const Found found = distance(mesh, mesh, Pose::translated(cells[0], cells[1], cells[2]));
      check_bounds(found, truth, 0);
      // The bounds differ by the part beyond the range, and no more.
      CHECK(found.upper - found.lower <= 256 * std::sqrt(axes) * (x - kRange) + 2);
    }
  }
  const Found farthest = distance(mesh, mesh, Pose::translated(1 << 29, 0, 0));
  CHECK_FALSE(farthest.in_range);
  CHECK(farthest.upper == UINT32_MAX);
}

TEST_CASE(
    "beyond the range bounds hold: of meshes twice as large, against brute force over halves") {
  for_rounds(rounds(60, 300), [&](Random& random, int round) {
    const bake::LatticeMesh half_a = random_mesh(random, 12, 6000, 2000);
    const bake::LatticeMesh half_b = random_mesh(random, 12, 6000, 2000);
    const AnyMesh small_a = any_mesh(random, half_a);
    const AnyMesh small_b = any_mesh(random, half_b);
    const AnyMesh a = any_mesh(random, doubled(half_a));
    const AnyMesh b = any_mesh(random, doubled(half_b));
    std::int32_t cells[3];
    for (std::int32_t& along : cells) {
      const std::int32_t sign = random.below(2) == 0 ? 1 : -1;
      along = sign * random.between(kRange / 2 + 1, kRange / 2 + 20000);
    }
    const bool rotated = round % 2 != 0;
    const std::int32_t twice[3] = {2 * cells[0], 2 * cells[1], 2 * cells[2]};
    const auto rotation = rotation_of(any_quaternion(random));
    const auto pose = [&](const std::int32_t(&at)[3]) {
      return rotated ? Pose::rigid(rotation.entry, at) : Pose::translated(at[0], at[1], at[2]);
    };
    const double truth =
        2 * length_of(least_of(all_distances(small_a, small_b, pose(cells))).squared);
    // Rotated vertices are rounded; the halves' vertices by up to two cells.
    const double rounded = rotated ? 3 : 1e-6;
    const Pose far = pose(twice);
    check_bounds(distance(a, b, far), truth, rounded);
    const auto any = [&] { return static_cast<std::uint16_t>(random.below(12)); };
    check_bounds(distance(a, b, far, Witness<std::uint16_t>{any(), any()}), truth, rounded);
    // In slices, too.
    ClearanceQuery cut(a, b, far);
    while (cut.run(9).status == Status::suspended) {
      const Found known = cut.result();
      REQUIRE((known.lower == 0 && known.witness.is_none()));
      REQUIRE((known.upper == UINT32_MAX || known.upper / 256.0 >= truth - rounded));
    }
    check_bounds(cut.result(), truth, rounded);
  });
}

TEST_CASE("beyond the range the meshes' own origins count") {
  Random random = test_random();
  bake::LatticeMesh at_a = largest_box();
  bake::LatticeMesh at_b = at_a;
  at_a.origin = {100000, -200000, 300000};
  at_b.origin = {-400000, 500000, 600000};
  const AnyMesh a = any_mesh(random, at_a);
  const AnyMesh b = any_mesh(random, at_b);
  // Turned by 90 degrees about z: B's origin goes to (-500,000, -400,000, 600,000).
  const std::int32_t one = kRotationOne;
  const std::int32_t turn[3][3] = {{0, -one, 0}, {one, 0, 0}, {0, 0, one}};
  const std::int32_t cells[3] = {600000 + kRange + 20000, 200000, -300000};
  check_bounds(distance(a, b, Pose::rigid(turn, cells)), kRange + 20000 - 2 * 16383, 0);
  check_bounds(distance(a, b, Pose::translated(500000 + kRange + 20000, -700000, -300000)),
               kRange + 20000 - 2 * 16383, 0);
}
