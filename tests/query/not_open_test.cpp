// Meshes that nobody opened: no answer permits anything.
#include "flashbvh/deformable.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/shape.hpp"
#include "support/bending.hpp"
#include "support/refused.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

/// Whether no query takes the mesh, alone, with itself or with an open one.
template <class Mesh>
bool is_not_open(const Mesh& mesh, const Mesh& open) {
  return is_refused(mesh, Status::not_open, Status::not_open) &&
         are_refused(mesh, mesh, Status::not_open) && are_refused(mesh, open, Status::not_open) &&
         are_refused(open, mesh, Status::not_open);
}

template <class Mesh>
void check_not_open() {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  const Bending<Mesh> baked(bake::build_default(ring), ring);
  const Mesh open = baked.baked.view();
  REQUIRE(open.is_closed);
  CHECK(is_not_open(Mesh{}, open));
  Mesh without_cell = open;
  without_cell.cell_bits = 0;
  CHECK(is_not_open(without_cell, open));
  without_cell.cell_bits = 1;  // too small for a length
  CHECK(is_not_open(without_cell, open));
  Mesh failed = open;
  const std::uint32_t damaged[32] = {kImageMagic};
  CHECK(open_image(damaged, sizeof damaged, failed) == Status::image_version);
  CHECK(is_not_open(failed, open));
  Node<typename Mesh::Index> nodes[1];
  Vertex vertices[1];
  BasicDeformableMesh<Mesh> deformable(Mesh{}, nodes, vertices);
  CHECK(is_not_open(deformable.mesh(), open));
  CHECK(deformable.refit().status == Status::not_open);
  CHECK(is_not_open(deformable.mesh(), open));
}

}  // namespace

TEST_CASE("no query, ray or refit takes a mesh that is not open") {
  check_not_open<Mesh>();
  check_not_open<Mesh32>();
}

TEST_CASE("a shape like a mesh that is not open is not open, wherever it is set") {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  const Bending<Mesh> baked(bake::build_default(ring), ring);
  const Mesh open = baked.baked.view();
  const Mesh none{};
  PointShape point(none, {1, 2, 3});
  BoxShape box(none, {0, 0, 0}, {9, 9, 9});
  for (int i = 0; i < 2; ++i) {
    CHECK(point.status() == Status::not_open);
    CHECK(box.status() == Status::not_open);
    CHECK(is_not_open(point.mesh(), open));
    CHECK(is_not_open(box.mesh(), open));
    CHECK(are_refused(point.mesh(), box.mesh(), Status::not_open));
    point.set({4, 5, 6});
    box.set({0, 0, 0}, {5, 5, 5});
  }
  CHECK(SegmentShape(none, {0, 0, 0}, {1, 1, 1}).status() == Status::not_open);
  CHECK(TriangleShape(none, {}).status() == Status::not_open);
}

TEST_CASE("a first contact takes no motion that no constructor made") {
  const bake::LatticeMesh ring = torus(6, 4, 60, 20);
  const Bending<Mesh> baked(bake::build_default(ring), ring);
  const Mesh open = baked.baked.view();
  Zeros<BodyMotion> motion;
  CHECK(FirstContact(open, open, *motion).run(UINT32_MAX).status == Status::not_open);
}
