// Queries under any pose: each traversal and layout against brute force on transformed triangles.
#include "support/any_mesh.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

/// The size of a scene: coordinates, triangles, and the translation.
struct Scale {
  std::int32_t spread;
  std::int32_t size;
  std::int32_t reach;
  bool is_translated = false;  ///< not rotated, with distant origins
};
constexpr Scale kSmall = {30, 25, 20};
constexpr Scale kTranslated = {30, 25, 20, true};
constexpr Scale kNear = {300, 200, 250};
constexpr Scale kLargest = {16383, 9000, 15000};
constexpr Scale kTouching = {3, 2, 2};  ///< most intersecting pairs touch or share a plane

/// Meshes before baking.
struct Meshes {
  bake::LatticeMesh a, b;
  Pose pose;
};

Meshes any_meshes(Random& random, std::uint32_t most, const Scale& scale) {
  Meshes meshes{random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                any_rigid_pose(random, scale.reach)};
  const std::int32_t farthest = scale.is_translated ? 5000 : random.below(2) == 0 ? 20 : 0;
  std::int32_t t[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    meshes.a.origin[axis] = random.between(-farthest, farthest);
    meshes.b.origin[axis] = random.between(-farthest, farthest);
    t[axis] =
        meshes.a.origin[axis] - meshes.b.origin[axis] + random.between(-scale.reach, scale.reach);
  }
  if (scale.is_translated) {
    meshes.pose = Pose::translated(t[0], t[1], t[2]);
  }
  return meshes;
}

void check_against_brute_force(const Scale& scale, std::size_t tries) {
  std::size_t pairs = 0;
  for_rounds(tries, [&](Random& random, std::size_t) {
    const Meshes meshes = any_meshes(random, 20, scale);
    REQUIRE(meshes.pose.status() == Status::done);
    const AnyMesh a = any_mesh(random, meshes.a);
    const AnyMesh b = any_mesh(random, meshes.b);
    pairs += check_all(a, b, meshes.pose);
  });
  CHECK(pairs > tries / 2);
}

}  // namespace

TEST_CASE("under any pose a query finds exactly the pairs that brute force finds") {
  check_against_brute_force(kTranslated, rounds<std::size_t>(40, 200));
  check_against_brute_force(kSmall, rounds<std::size_t>(30, 120));
  check_against_brute_force(kNear, rounds<std::size_t>(30, 80));
  check_against_brute_force(kLargest, rounds<std::size_t>(30, 80));
  check_against_brute_force(kTouching, rounds<std::size_t>(30, 80));
}

TEST_CASE("a mesh that reaches another with its farthest tip alone is found") {
  int reached = 0;
  for_rounds(2000, 10, [&](Random& random, int) {
    // A needle along an axis or a diagonal, with its tip at the end of the lattice.
    const auto end = [&random] { return static_cast<std::int16_t>(random.below(2) * 16383); };
    const Vertex tip = {16383, end(), end()};
    const Pose pose = any_rigid_pose(random, 47000);
    bake::LatticeMesh needle;
    needle.vertices = {{0, 0, 0}, {0, 1, 1}, tip};
    needle.triangles = {{0, 1, 2}};
    // A is the tip's transformed point, if it lies on the lattice.
    const Point at = transformed(needle, tip, pose);
    if (std::abs(at.x) > 16383 || std::abs(at.y) > 16383 || std::abs(at.z) > 16383) {
      return;
    }
    ++reached;
    bake::LatticeMesh point;
    point.vertices = {vertex_of(at)};
    point.triangles = {{0, 0, 0}};
    const auto a = baked(bake::build_median(point, 1), point);
    const auto b = baked(bake::build_median(needle, 1), needle);
    const Mesh mesh_a = a.view();
    const Mesh mesh_b = b.view();
    PairQuery query(mesh_a, mesh_b, pose);
    REQUIRE(run_to_end(query) == Pairs{{0, 0}});
  });
  CHECK(reached > 30);
}

TEST_CASE("offsets beyond all reach, and at its edge, under rotation") {
  const std::int32_t reaches[] = {16384, 40000, 44760,  48000,
                                  48001, 65536, 100000, kMaxTranslation};
  for_rounds(400, 9, [&](Random& random, int) {
    Meshes meshes = any_meshes(random, 8, kLargest);
    std::int32_t cells[3];
    for (std::int32_t& axis : cells) {
      axis = random.below(2) == 0 ? random.between(-3, 3) : random.one_of(reaches);
      axis = random.below(2) == 0 ? axis : -axis;
    }
    meshes.a.origin = meshes.b.origin = {0, 0, 0};
    const AnyMesh a = any_mesh(random, meshes.a);
    const AnyMesh b = any_mesh(random, meshes.b);
    const Pose pose = Pose::rigid(rotation_of(any_quaternion(random)).entry, cells);
    if (std::abs(cells[0]) > 60000 || std::abs(cells[1]) > 60000 || std::abs(cells[2]) > 60000) {
      check_pairs(a.view<MeshWithLevels>(), b.view<MeshWithLevels>(), pose, {});
    } else {
      check_all(a, b, pose);
    }
  });
}
