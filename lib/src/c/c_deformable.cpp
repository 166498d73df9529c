// The C interface to deformable meshes.
//
// A C struct begins with the mesh that queries take, as DeformableMesh does.
#include "flashbvh/deformable.hpp"
#include "flashbvh/self.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_node, Node<uint16_t>);
FLASHBVH_HOLDS(flashbvh_deformable, DeformableMesh);

static_assert(sizeof(flashbvh_node) == sizeof(Node<uint16_t>), "C's nodes are nodes");
static_assert(__is_standard_layout(flashbvh_deformable), "its mesh is at its address");

void flashbvh_deformable_make(flashbvh_deformable* deformable, const flashbvh_mesh* baked,
                              flashbvh_node* nodes, flashbvh_vertex* vertices) {
  make_in_place(deformable, object_in(baked), &object_in(nodes), vertices);
}

flashbvh_status flashbvh_deformable_refit(flashbvh_deformable* deformable, uint32_t work,
                                          uint32_t* vertex) {
  const RefitResult step = object_in(deformable).refit(work);
  if (step.status == Status::vertex_out_of_lattice) {
    *vertex = step.vertex;
  }
  return c_status(step.status);
}

flashbvh_status flashbvh_intersects_itself(const flashbvh_mesh* mesh, bool* yes) {
  return put_answer(intersects_itself(object_in(mesh)), yes);
}
