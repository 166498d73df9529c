// The C interface to meshes that bend and to self queries.
//
// A C struct begins with the mesh that queries take, as DeformableMesh does.
#include "flashbvh/deformable.h"
#include "flashbvh/deformable.hpp"
#include "flashbvh/self.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_node, Node<uint16_t>);
FLASHBVH_HOLDS(flashbvh_deformable, DeformableMesh);
FLASHBVH_HOLDS(flashbvh_self_query, DeformableQuery<SelfQuery>);
FLASHBVH_HOLDS(flashbvh_self_within_query, DeformableQuery<SelfWithinQuery>);

static_assert(sizeof(flashbvh_node) == sizeof(Node<uint16_t>), "C's nodes are nodes");
static_assert(__is_standard_layout(flashbvh_deformable), "its mesh is at its address");

namespace {

template <class Query>
flashbvh_self_cursor cursor_of(const Query& query) {
  const auto cursor = query.cursor();
  return {cursor.at, cursor.refits};
}

template <class Query>
flashbvh_status resume(Query& query, const flashbvh_self_cursor& cursor) {
  return c_status(query.resume({cursor.at, cursor.refits}));
}

}  // namespace

uint32_t flashbvh_mesh_nodes(const flashbvh_mesh* mesh) {
  return object_in(mesh).node_count;
}

uint32_t flashbvh_mesh_vertices(const flashbvh_mesh* mesh) {
  return object_in(mesh).vertex_count;
}

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

uint32_t flashbvh_deformable_refits(const flashbvh_deformable* deformable) {
  return object_in(deformable).refits();
}

flashbvh_status flashbvh_self_query_start(flashbvh_self_query* query,
                                          const flashbvh_deformable* deformable) {
  return c_status(make(query, object_in(deformable)).status());
}

flashbvh_run_result flashbvh_self_query_run(flashbvh_self_query* query, uint32_t work,
                                            flashbvh_pair* pairs, uint32_t capacity) {
  return object_in(query).run(work, pairs, capacity);
}

flashbvh_stats flashbvh_self_query_stats(const flashbvh_self_query* query) {
  return object_in(query).query().stats();
}

flashbvh_self_cursor flashbvh_self_query_cursor(const flashbvh_self_query* query) {
  return cursor_of(object_in(query));
}

flashbvh_status flashbvh_self_query_resume(flashbvh_self_query* query,
                                           const flashbvh_self_cursor* cursor) {
  return resume(object_in(query), *cursor);
}

flashbvh_status flashbvh_self_within_start(flashbvh_self_within_query* query,
                                           const flashbvh_deformable* deformable,
                                           flashbvh_fine_length distance) {
  return c_status(make(query, object_in(deformable), within(distance)).status());
}

flashbvh_run_result flashbvh_self_within_run(flashbvh_self_within_query* query, uint32_t work,
                                             flashbvh_pair* pairs, uint32_t capacity) {
  return object_in(query).run(work, pairs, capacity);
}

flashbvh_stats flashbvh_self_within_stats(const flashbvh_self_within_query* query) {
  return object_in(query).query().stats();
}

flashbvh_self_cursor flashbvh_self_within_cursor(const flashbvh_self_within_query* query) {
  return cursor_of(object_in(query));
}

flashbvh_status flashbvh_self_within_resume(flashbvh_self_within_query* query,
                                            const flashbvh_self_cursor* cursor) {
  return resume(object_in(query), *cursor);
}

flashbvh_status flashbvh_intersects_itself(const flashbvh_mesh* mesh, bool* yes) {
  return put_answer(intersects_itself(object_in(mesh)), yes);
}
