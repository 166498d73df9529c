// Separation of triangles and boxes in flash along a direction, against exact distances.
#include "flashbvh/detail/bounds/leaf_gap.hpp"

#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/query/within_along.hpp"
#include "support/all_distances.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"
#include "support/vectors.hpp"

using namespace flashbvh::detail;

namespace {

Scene any_scene(Random& random, int round) {
  // Few cells or many, with distances about the meshes' size.
  const std::int32_t spread = round % 3 == 0 ? 5000 : 10 + 20 * (round % 7);
  const auto mesh = [&] { return any_mesh(random, 14, spread, 1 + spread / 4); };
  return {mesh(), mesh(), any_pose(random, 3 * spread)};
}

/// A random non-zero direction: long or short, sometimes along an axis.
PackedVector any_direction(Random& random) {
  const std::int32_t most = (2 << random.below(kDirectionBits)) - 1;
  const auto part = [&] { return random.below(4) == 0 ? 0 : random.between(-most, most); };
  const std::int32_t x = part();
  const std::int32_t y = part();
  const std::int32_t z = part();
  return {join_halves(static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)),
          x == 0 && y == 0 && z == 0 ? most : z};
}

/// The leaf's node of each triangle.
std::vector<std::uint32_t> leaf_nodes(const Mesh& mesh) {
  std::vector<std::uint32_t> node(mesh.triangle_count);
  for (std::uint32_t i = 0; i < mesh.node_count; ++i) {
    if (mesh.nodes[i].is_leaf()) {
      const std::uint32_t leaf = mesh.nodes[i].leaf();
      for (std::uint32_t t = mesh.first_triangle(leaf); t < mesh.end_triangle(leaf); ++t) {
        node[t] = i;
      }
    }
  }
  return node;
}

/// Triangles about a corner, in one leaf, nearly in the plane across `up` there.
AnyMesh fan(Random& random, const FloatVector& up, std::int32_t reach) {
  bake::LatticeMesh mesh;
  const auto add = [&](double at, double height) {
    FloatVector corner;
    for (double& along : corner) {
      along = at * (random.between(-1000, 1000) / 1000.0);
    }
    const FloatVector on_plane = plus(corner, height - dot(corner, up), up);
    const auto rounded = [&](std::size_t axis) {
      return static_cast<std::int16_t>(std::lround(on_plane[axis]));
    };
    mesh.vertices.push_back({rounded(0), rounded(1), rounded(2)});
  };
  add(0, 0);
  for (std::uint32_t i = 1; i < 7; i += 2) {
    add(reach, random.between(-reach / 50 - 4, 1));
    add(reach, random.between(-reach / 50 - 4, 1));
    mesh.triangles.push_back({0, i, i + 1});
  }
  return AnyMesh(bake::build_median(mesh, 3), mesh);
}

}  // namespace

TEST_CASE(
    "no direction separates triangles that are within the limit, nor their boxes and leaves") {
  long separated = 0;
  long boxes = 0;
  long leaves = 0;
  for_rounds(rounds(200, 2000), [&](Random& random, int round) {
    const Scene scene = any_scene(random, round);
    const Mesh& a = scene.a;
    const Mesh& b = scene.b;
    const std::vector<Pairwise> all = all_distances(a, b, scene.pose);
    Transform transform(scene.pose, a, b, /*may_stop=*/false);
    transform.bring_near();
    transform.prepare(b);
    const std::vector<std::uint32_t> node_a = leaf_nodes(a);
    const std::vector<std::uint32_t> node_b = leaf_nodes(b);
    for (int i = 0; i < 8; ++i) {
      // The limit is the distance of some pair, rounded down to whole cells.
      const Pairwise& near = random.one_of(all);
      const auto cells = static_cast<std::int64_t>(length_of(near.squared));
      const std::int64_t limit = cells * cells;
      const ShortFraction within_limit = {static_cast<std::uint64_t>(limit), 1};
      const LeafGap gap(any_direction(random), transform, limit);
      const SupportGap support(gap);
      for (const Pairwise& pair : all) {
        Triangle of_a;
        Triangle of_b;
        place_pair(a, pair.of_a, b, pair.of_b, transform, of_a, of_b);
        const bool is_near = is_within(of_a, of_b, within_limit);
        const bool by_gap = gap.separates(gap.end_of_a(a, pair.of_a), gap.start_of_b(b, pair.of_b));
        Direction any;
        CAPTURE(pair.of_a, pair.of_b, limit);
        REQUIRE(!(is_near && by_gap));
        REQUIRE(!(is_near && boxes_separate(of_a, of_b, limit, any)));
        REQUIRE(!(is_near && edges_separate(of_a, of_b, limit, any)));
        separated += by_gap ? 1 : 0;

        const auto& box_a = a.nodes[node_a[pair.of_a]].box;
        const auto& box_b = b.nodes[node_b[pair.of_b]].box;
        const bool by_boxes = support.separates(box_a, box_b);
        const std::int32_t end_a = support.end_of(a, Side::a, a.nodes[node_a[pair.of_a]].leaf());
        const std::int32_t end_b = support.end_of(b, Side::b, b.nodes[node_b[pair.of_b]].leaf());
        const bool by_leaf_a =
            SupportGap::end_along(support.row_beside(Side::a), box_b) <= support.most_beside(end_a);
        const bool by_leaf_b =
            SupportGap::end_along(support.row_beside(Side::b), box_a) <= support.most_beside(end_b);
        const bool by_leaves = end_b <= support.most_beside(end_a);
        REQUIRE(by_leaves == (end_a <= support.most_beside(end_b)));
        // A tighter test separates whenever a looser one does, and none separates near pairs.
        REQUIRE(!(by_boxes && !(by_leaf_a && by_leaf_b)));
        REQUIRE(!((by_leaf_a || by_leaf_b) && !by_leaves));
        REQUIRE(!(by_leaves && !by_gap));
        boxes += by_boxes ? 1 : 0;
        leaves += by_leaves && !by_leaf_a && !by_leaf_b ? 1 : 0;
      }
    }
  });
  CAPTURE(separated, boxes, leaves);
  CHECK(separated > 1000);
  CHECK(boxes > 100);
  CHECK(leaves > 10);
}

TEST_CASE("leaves that have nothing but ties have no triangles that are nearer") {
  std::uint32_t ties = 0;
  std::uint32_t nearer = 0;
  for_rounds(rounds(3000u, 30000u), [&](Random& random, int) {
    const Pose turn = any_pose(random, 0);
    const std::int32_t reach = 40 << random.below(9);
    const FloatVector apart = {1.0 * random.between(-1000, 1000), 1.0 * random.between(-1000, 1000),
                               1.0 * random.between(1, 1000)};
    const FloatVector up = times(1 / length_of(apart), apart);
    FloatVector down = {0, 0, 0};  // in B's lattice
    for (unsigned i = 0; i < 9; ++i) {
      down[i % 3] -= up[i / 3] * turn.rotation(int(i / 3), int(i % 3)) / kRotationOne;
    }
    const AnyMesh a = fan(random, up, reach);
    const AnyMesh b = fan(random, down, reach);
    const double far = random.between(reach / 40 + 2, reach);
    const std::int32_t cells[3] = {static_cast<std::int32_t>(std::lround(up[0] * far)),
                                   static_cast<std::int32_t>(std::lround(up[1] * far)),
                                   static_cast<std::int32_t>(std::lround(up[2] * far))};
    const Pose pose = Pose::relative(Pose::translated(-cells[0], -cells[1], -cells[2]), turn);
    const std::vector<Pairwise> all = all_distances(a, b, pose);
    Transform transform(pose, a, b, /*may_stop=*/false);
    transform.prepare(b);
    // With this pair as the nearest so far.
    Nearest<std::uint16_t> nearest;
    NearestSoFar so_far(transform);
    nearest.so_far = &so_far;
    Triangle of_a;
    Triangle of_b;
    translate_triangle(a, all[0].of_a, kNoOffset, of_a);
    transform_triangle(b, all[0].of_b, transform, of_b);
    REQUIRE(nearest.take(of_a, of_b));
    nearest.nearest_a = all[0].of_a;
    nearest.nearest_b = all[0].of_b;
    if (nearest.intersect) {
      return;
    }
    const bool are_ties =
        nearest.ties_alone(a, Side::a, a.nodes[0]) && nearest.ties_alone(b, Side::b, b.nodes[0]);
    const bool is_any_nearer = compare(least_of(all).squared, all[0].squared) < 0;
    REQUIRE(!(are_ties && is_any_nearer));
    ties += are_ties ? 1 : 0;
    nearer += is_any_nearer ? 1 : 0;
  });
  CAPTURE(ties, nearer);
  CHECK(ties > 100);
  CHECK(nearer > 100);
}

TEST_CASE("along a direction the same pairs are found as without, however the query is cut") {
  for_rounds(rounds(100, 1000), [&](Random& random, int round) {
    const Scene scene = any_scene(random, round);
    const Mesh& a = scene.a;
    const Mesh& b = scene.b;
    const std::vector<Pairwise> all = all_distances(a, b, scene.pose);
    const std::uint32_t distance = lower_of(random.one_of(all).squared) + 1;
    WithinQuery reference(a, b, scene.pose, {}, within({distance}));
    const Pairs expected = run_to_end(reference);
    constexpr std::uint32_t budgets[] = {1, 7, 100, UINT32_MAX};
    for (const std::uint32_t work : budgets) {
      CAPTURE(distance, work);
      Query<Ranked<Mesh>, WithinAlong> query(a, b, scene.pose, {}, WithinAlong(within({distance})));
      REQUIRE(run_to_end(query, work) == expected);
    }
  });
}
