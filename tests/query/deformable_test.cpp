// Deformable meshes: boxes against boxes computed from the triangles below, queries against brute
// force and rebaked meshes, and refusals during changes of a mesh.
#include "flashbvh/clearance.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/solid.hpp"
#include "support/any_mesh.hpp"
#include "support/bending.hpp"
#include "support/refused.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"
#include "support/vectors.hpp"

namespace {

/// The box of all vertices below a node, gathered top down.
template <class Mesh>
void add_vertices(const Mesh& mesh, std::uint32_t node, Box& box) {
  if (!mesh.nodes[node].is_leaf()) {
    for (std::uint32_t child = mesh.first_child(node);; child = mesh.next_sibling(child)) {
      add_vertices(mesh, child, box);
      if (mesh.is_last_child(node, child)) {
        return;
      }
    }
  }
  const std::uint32_t leaf = mesh.nodes[node].leaf();
  for (std::uint32_t i = mesh.first_triangle(leaf); i < mesh.end_triangle(leaf); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i].corner) {
      for (const auto axis : kVertexAxes) {
        box.lower.*axis = std::min(box.lower.*axis, mesh.vertices[corner].*axis);
        box.upper.*axis = std::max(box.upper.*axis, mesh.vertices[corner].*axis);
      }
    }
  }
}

template <class Mesh>
PackedBox box_below(const Mesh& mesh, std::uint32_t node) {
  constexpr std::int16_t most = kMaxCoordinate;
  constexpr std::int16_t least = -kMaxCoordinate;
  Box box = {{most, most, most}, {least, least, least}};
  add_vertices(mesh, node, box);
  return pack(box);
}

/// Refits in slices of up to `most` nodes.
template <class Mesh>
RefitResult refit_in_slices(Random& random, BasicDeformableMesh<Mesh>& mesh, std::uint32_t most) {
  for (;;) {
    const RefitResult step = mesh.refit(1 + random.below(most));
    if (step.status != Status::suspended) {
      return step;
    }
  }
}

template <class Mesh>
void check_refits(Random& random, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const bake::LatticeMesh lattice = any_bendable(random);
    const bake::BuildTree tree = any_tree(random, lattice);
    Bending<Mesh> bent(tree, lattice, random.below(4) != 0);
    const Mesh& mesh = bent.mesh.mesh();
    for (int frame = 0; frame < 8; ++frame) {
      CAPTURE(frame);
      move_some(random, frame < 6 ? 20 : kMaxCoordinate, bent.vertices);
      const RefitResult step =
          frame % 2 == 0 ? bent.mesh.refit() : refit_in_slices(random, bent.mesh, 9);
      REQUIRE(step.status == Status::done);
      std::int64_t longest = 0;
      for (std::uint32_t node = 0; node < mesh.node_count; ++node) {
        CAPTURE(node);
        REQUIRE(test::same(mesh.nodes[node].box, box_below(mesh, node)));
        REQUIRE(mesh.nodes[node].link == bent.baked.nodes[node].link);
        REQUIRE(mesh.nodes[node].data == bent.baked.nodes[node].data);
      }
      for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
        for (int side = 0; side < 3; ++side) {
          const auto at = [&](int corner) {
            return vector_of<std::int64_t>(mesh.vertices[mesh.triangles[i].corner[corner]]);
          };
          const Vector<std::int64_t> edge = minus(at(side), at((side + 1) % 3));
          longest = std::max(longest, dot(edge, edge));
        }
      }
      REQUIRE(std::int64_t{mesh.longest_edge} * mesh.longest_edge >= longest);
      REQUIRE(mesh.is_closed == bent.baked.is_closed);
      REQUIRE(mesh.cell_bits == bent.baked.view().cell_bits);
    }
  }
}

template <class Mesh>
void check_queries(Random& random, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const bake::LatticeMesh lattice = any_bendable(random);
    Bending<Mesh> bent(any_tree(random, lattice), lattice);
    const bake::LatticeMesh other = any_bendable(random);
    Bending<Mesh> rigid(any_tree(random, other), other);
    for (int frame = 0; frame < 2; ++frame) {
      move_some(random, 30, bent.vertices);
      REQUIRE(refit_in_slices(random, bent.mesh, 30).status == Status::done);
      const Pose pose = any_pose(random, 20);
      const Mesh& mesh = bent.mesh.mesh();
      const bake::LatticeMesh now = bent.now();
      check_pairs(mesh, rigid.mesh.mesh(), pose, brute_force(now, other, pose));
      check_pairs(rigid.mesh.mesh(), mesh, pose, brute_force(other, now, pose));
      check_pairs(mesh, mesh, pose, brute_force(now, now, pose));
    }
  }
}

}  // namespace

TEST_CASE(
    "a refit's boxes are those of the triangles below, whatever moved and however it is cut") {
  Random random = test_random();
  check_refits<MeshWithLevels>(random, 60);
  check_refits<PreMeshWithLevels>(random, 30);
  check_refits<Mesh>(random, 20);
}

TEST_CASE("every traversal takes a mesh that bends, on either side and against itself") {
  Random random = test_random(1);
  check_queries<MeshWithLevels>(random, 20);
  check_queries<PreMeshWithLevels>(random, 20);
}

TEST_CASE("distances, rays and insides are those of the same mesh baked as it is now") {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  for_rounds(40, 2, [&](Random& random, int) {
    Bending<Mesh> bent(any_tree(random, ring), ring);
    move_some(random, 8, bent.vertices);
    bent.mesh.set_origin({random.between(-50, 50), 7, -3});
    REQUIRE(bent.mesh.refit().status == Status::done);
    bake::LatticeMesh now = bent.now();
    std::copy(bent.mesh.mesh().origin, bent.mesh.mesh().origin + 3, now.origin.begin());
    const Bending<Mesh> anew(bake::build_default(now), now);
    const Mesh& mesh = bent.mesh.mesh();
    const Mesh& same = anew.mesh.mesh();
    REQUIRE((mesh.is_closed && same.is_closed));

    const Pose pose = any_pose(random, 250);
    const auto near = distance(mesh, mesh, pose);
    const auto expected = distance(same, same, pose);
    REQUIRE((near.status == Status::done && near.lower == expected.lower));
    REQUIRE(solids_intersect(mesh, same, pose).yes == solids_intersect(same, mesh, pose).yes);
    const Point p = {random.between(-90, 90), random.between(-90, 90), random.between(-30, 30)};
    REQUIRE(inside(mesh, p).side == inside(same, p).side);
    const Segment ray = {p, {random.between(-200, 200), random.between(-200, 200), 5}};
    const auto hit = nearest_hit(mesh, ray);
    const auto expected_hit = nearest_hit(same, ray);
    REQUIRE(hit.yes == expected_hit.yes);
    REQUIRE((!hit.yes || hit.hit.triangle == expected_hit.hit.triangle));
  });
}

TEST_CASE(
    "a vertex out of the lattice is refused by its number, and no query runs until it is back") {
  Random random = test_random();
  const bake::LatticeMesh lattice = grid(3, 2, false);
  Bending<Mesh> bent(bake::build_default(lattice), lattice);
  const auto coordinate = [&](std::size_t v, int axis) -> std::int16_t& {
    return bent.vertices[v].*kVertexAxes[axis];
  };
  const Mesh& mesh = bent.mesh.mesh();
  const Mesh rigid = bent.baked.view();
  for (std::size_t v = 0; v < bent.vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(v, axis);
      for (const int good : {-16383, 16383}) {
        coordinate(v, axis) = static_cast<std::int16_t>(good);
        REQUIRE(bent.mesh.refit().status == Status::done);
      }
      for (const int bad : {-16384, 16384, -32768, 32767}) {
        coordinate(v, axis) = static_cast<std::int16_t>(bad);
        const RefitResult step = refit_in_slices(random, bent.mesh, 5);
        REQUIRE(step.status == Status::vertex_out_of_lattice);
        REQUIRE(step.vertex == v);
        REQUIRE(intersects(mesh, rigid, Pose::translated(0, 0, 0)).status == Status::cell_mismatch);
        REQUIRE(DeformableQuery<SelfQuery>(bent.mesh).status() == Status::mesh_changed);
        REQUIRE(intersects_itself(mesh).status == Status::cell_mismatch);
        REQUIRE(intersects_itself(mesh).yes);
      }
      coordinate(v, axis) = 0;
      REQUIRE(bent.mesh.refit().status == Status::done);
      REQUIRE(intersects(mesh, rigid, Pose::translated(0, 0, 0)).status == Status::done);
    }
  }
}

TEST_CASE("no query takes two meshes whose refits are not done, nor one of them with itself") {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  Bending<Mesh> first(bake::build_default(ring), ring);
  Bending<Mesh> second(bake::build_default(ring), ring);
  const Mesh& a = first.mesh.mesh();
  const Mesh& b = second.mesh.mesh();
  const Mesh rigid = first.baked.view();
  REQUIRE(first.mesh.refit(2).status == Status::suspended);
  second.vertices[0].x = 20000;
  REQUIRE(second.mesh.refit().status == Status::vertex_out_of_lattice);
  CHECK(are_refused(a, b));
  CHECK(are_refused(b, a));
  CHECK(are_refused(a, a));
  CHECK(are_refused(rigid, a));
  CHECK(are_refused(b, rigid));
  REQUIRE(first.mesh.refit().status == Status::done);
  CHECK(are_refused(a, b));
  CHECK(are_refused(b, a));
  CHECK_FALSE(are_refused(a, rigid));
}

TEST_CASE(
    "a query and a position from before a refit are refused, a refit between slices included") {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  Bending<Mesh> bent(bake::build_default(ring), ring);
  Bending<Mesh> other(bake::build_default(ring), ring);
  const Mesh rigid = bent.baked.view();
  const Pose pose = Pose::translated(30, 5, 0);
  using Dated = DeformableQuery<PairQuery>;

  const auto refuses = [](Dated& query, auto& refit) {
    PairQuery::Pair found[4];
    REQUIRE(query.run(40, found).status != Status::done);
    const auto position = query.cursor();
    REQUIRE(query.resume(position) == Status::suspended);
    refit();
    REQUIRE(query.is_outdated());
    REQUIRE(query.status() == Status::mesh_changed);
    const RunResult step = query.run(40, found);
    REQUIRE((step.status == Status::mesh_changed && step.count == 0 && step.work == 0));
    REQUIRE(query.run(40, [](const PairQuery::Pair&) { return true; }).status ==
            Status::mesh_changed);
    REQUIRE(query.resume(position) == Status::mesh_changed);
    return position;
  };
  auto whole = [&] { REQUIRE(bent.mesh.refit().status == Status::done); };
  auto part = [&] { REQUIRE(bent.mesh.refit(2).status == Status::suspended); };

  Dated both(bent.mesh, other.mesh, pose);
  const auto position = refuses(both, whole);
  Dated anew(bent.mesh, other.mesh, pose);
  REQUIRE(anew.resume(position) == Status::mesh_changed);
  REQUIRE(anew.status() == Status::suspended);

  Dated first(bent.mesh, rigid, pose);
  (void)refuses(first, part);
  REQUIRE(!inside(bent.mesh.mesh(), {0, 0, 0}).visits);
  REQUIRE(inside(bent.mesh.mesh(), {0, 0, 0}).status == Status::not_closed);
  Dated begun(rigid, bent.mesh, pose);
  REQUIRE(begun.status() == Status::mesh_changed);
  whole();  // ends the slice's refit
  REQUIRE(begun.status() == Status::mesh_changed);
  Dated second(rigid, bent.mesh, pose);
  (void)refuses(second, part);

  // After start_again(), vertices that moved during a refit count.
  bent.vertices[bent.baked.triangles.back().corner[0]].x += 3;
  bent.mesh.start_again();
  whole();
  REQUIRE(test::same(bent.nodes[0].box, box_below(bent.mesh.mesh(), 0)));

  const Pose beside = Pose::translated(200, 0, 0);
  DeformableQuery<ClearanceQuery> near(bent.mesh, rigid, beside);
  REQUIRE(near.run(UINT32_MAX).status == Status::done);
  const auto nearest = near.cursor();
  whole();
  REQUIRE(near.run(UINT32_MAX).status == Status::mesh_changed);
  REQUIRE(near.resume(nearest) == Status::mesh_changed);
}
