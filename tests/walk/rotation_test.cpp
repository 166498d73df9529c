// Queries under any pose: each traversal and layout against brute force on transformed triangles.
#include "support/points.hpp"
#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/transformed_mesh.hpp"

using namespace flashbvh::detail;

namespace {

template <Layout layout = Layout::post_indexed>
struct Scene {
  bake::LatticeMesh mesh_a, mesh_b;
  Pose pose;
  Baked<layout> a, b;

  Pairs brute_force() const { return test::brute_force(mesh_a, mesh_b, pose); }
  /// Bakes a tree of each mesh, with one triangle per leaf.
  void bake_median() {
    a = baked(bake::build_median(mesh_a, 1), mesh_a);
    b = baked(bake::build_median(mesh_b, 1), mesh_b);
  }
};

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

template <Layout layout = Layout::post_indexed>
Scene<layout> any_scene(Random& random, std::uint32_t most, const Scale& scale) {
  Scene<layout> scene{random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                      random_mesh(random, 1 + random.below(most), scale.spread, scale.size),
                      any_rigid_pose(random, scale.reach),
                      {},
                      {}};
  const std::int32_t farthest = scale.is_translated ? 5000 : random.below(2) == 0 ? 20 : 0;
  std::int32_t t[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    scene.mesh_a.origin[axis] = random.between(-farthest, farthest);
    scene.mesh_b.origin[axis] = random.between(-farthest, farthest);
    t[axis] = scene.mesh_a.origin[axis] - scene.mesh_b.origin[axis] +
              random.between(-scale.reach, scale.reach);
  }
  if (scale.is_translated) {
    scene.pose = Pose::translated(t[0], t[1], t[2]);
  }
  scene.a = baked<layout>(any_tree(random, scene.mesh_a), scene.mesh_a);
  scene.b = baked<layout>(any_tree(random, scene.mesh_b), scene.mesh_b);
  return scene;
}

template <class Traversal>
void check_against_brute_force(Random& random, const Scale& scale, int tries) {
  std::size_t total = 0;
  for (int round = 0; round < tries; ++round) {
    CAPTURE(round);
    const auto scene = any_scene<Traversal::Tree::kLayout>(random, 20, scale);
    REQUIRE(scene.pose.status() == Status::done);
    AnyQuery<Traversal> any(scene);
    const Pairs pairs = sorted(run_to_end(any.query));
    REQUIRE(any.query.status() == Status::done);
    REQUIRE(any.query.stats().triangle_pairs == pairs.size());
    REQUIRE(pairs == scene.brute_force());
    total += pairs.size();
  }
  CHECK(total > static_cast<std::size_t>(tries) / 2);
}

}  // namespace

TEST_CASE("under any pose a query finds exactly the pairs that brute force finds") {
  for_each_order<std::uint16_t>([](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    Random random = test_random();
    check_against_brute_force<Traversal>(random, kTranslated, rounds(20, 100));
    check_against_brute_force<Traversal>(random, kSmall, rounds(15, 60));
    check_against_brute_force<Traversal>(random, kNear, rounds(15, 40));
    check_against_brute_force<Traversal>(random, kLargest, rounds(15, 40));
    check_against_brute_force<Traversal>(random, kTouching, rounds(15, 40));
  });
}

TEST_CASE("a mesh that reaches another with its farthest tip alone is found") {
  int reached = 0;
  for_rounds(2000, 10, [&](Random& random, int) {
    // A needle along an axis or a diagonal, with its tip at the end of the lattice.
    const auto end = [&random] { return static_cast<std::int16_t>(random.below(2) * 16383); };
    const Vertex tip = {16383, end(), end()};
    Scene<> scene{{}, {}, any_rigid_pose(random, 47000), {}, {}};
    scene.mesh_b.vertices = {{0, 0, 0}, {0, 1, 1}, tip};
    scene.mesh_b.triangles = {{0, 1, 2}};
    // A is the tip's transformed point, if it lies on the lattice.
    const Point at = transformed(scene.mesh_b, tip, scene.pose);
    if (std::abs(at.x) > 16383 || std::abs(at.y) > 16383 || std::abs(at.z) > 16383) {
      return;
    }
    ++reached;
    scene.mesh_a.vertices = {vertex_of(at)};
    scene.mesh_a.triangles = {{0, 0, 0}};
    scene.bake_median();
    AnyQuery<Ranked<Mesh>> any(scene);
    REQUIRE(run_to_end(any.query) == Pairs{{0, 0}});
  });
  CHECK(reached > 30);
}

TEST_CASE("offsets beyond all reach, and at its edge, under rotation") {
  const std::int32_t reaches[] = {16384, 40000, 44760,  48000,
                                  48001, 65536, 100000, kMaxTranslation};
  for_rounds(400, 9, [&](Random& random, int) {
    auto scene = any_scene(random, 8, kLargest);
    std::int32_t cells[3];
    for (std::int32_t& axis : cells) {
      axis = random.below(2) == 0 ? random.between(-3, 3) : random.one_of(reaches);
      axis = random.below(2) == 0 ? axis : -axis;
    }
    scene.mesh_b.origin = {0, 0, 0};
    scene.mesh_a.origin = {0, 0, 0};
    scene.a.origin = scene.b.origin = {0, 0, 0};
    scene.pose = Pose::rigid(rotation_of(any_quaternion(random)).entry, cells);
    AnyQuery<Ranked<Mesh>> any(scene);
    const Pairs pairs = sorted(run_to_end(any.query));
    AnyQuery<LeafPost> leaf(scene);
    REQUIRE(pairs == sorted(run_to_end(leaf.query)));
    const bool far =
        std::abs(cells[0]) > 60000 || std::abs(cells[1]) > 60000 || std::abs(cells[2]) > 60000;
    REQUIRE((!far || pairs.empty()));
    REQUIRE((far || pairs == scene.brute_force()));
  });
}
