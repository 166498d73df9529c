// The C interface to meshes that bend and to self queries.
//
// A C struct begins with the mesh that queries take, as a DeformableMesh does.
#include "flashbvh/deformable.hpp"

#include "flashbvh/deformable.h"
#include "flashbvh/self.hpp"
#include "objects.hpp"

using namespace flashbvh;

namespace {

using DeformableSelfQuery = DeformableQuery<SelfQuery>;
using DeformableBand = DeformableQuery<SelfWithinQuery>;

static_assert(sizeof(flashbvh_node) == sizeof(Node<uint16_t>), "C's nodes are nodes");
static_assert(sizeof(flashbvh_vertex) == sizeof(Vertex), "C's vertices are vertices");
static_assert(sizeof(DeformableMesh) <= sizeof(flashbvh_deformable),
              "the struct in deformable.h is too small");
static_assert(alignof(DeformableMesh) <= alignof(flashbvh_deformable),
              "the struct in deformable.h is not aligned");
static_assert(__is_standard_layout(flashbvh_deformable), "its mesh is at its address");

}  // namespace

namespace flashbvh {

static DeformableMesh& object_in(flashbvh_deformable* deformable) {
  return *reinterpret_cast<DeformableMesh*>(deformable);
}
static const DeformableMesh& object_in(const flashbvh_deformable* deformable) {
  return *reinterpret_cast<const DeformableMesh*>(deformable);
}
static DeformableSelfQuery& object_in(flashbvh_self_query* query) {
  return *reinterpret_cast<DeformableSelfQuery*>(query->opaque.bytes);
}
static const DeformableSelfQuery& object_in(const flashbvh_self_query* query) {
  return *reinterpret_cast<const DeformableSelfQuery*>(query->opaque.bytes);
}
static DeformableBand& object_in(flashbvh_self_within_query* query) {
  return *reinterpret_cast<DeformableBand*>(query->opaque.bytes);
}
static const DeformableBand& object_in(const flashbvh_self_within_query* query) {
  return *reinterpret_cast<const DeformableBand*>(query->opaque.bytes);
}

template <class Query>
static flashbvh_status run_self(Query& query, uint32_t work, flashbvh_pair* pairs,
                                uint32_t capacity, uint32_t* count) {
  static_assert(sizeof(flashbvh_pair) == sizeof(typename Query::Pair), "C's pairs are pairs");
  const Step step = query.run(work, reinterpret_cast<typename Query::Pair*>(pairs), capacity);
  *count = step.count;
  return c_status(step.status);
}

template <class Query>
static flashbvh_self_position self_position(const Query& query) {
  const auto at = query.position();
  return {c_position(at.position), at.refits};
}

template <class Query>
static flashbvh_status resume_self(Query& query, const flashbvh_self_position& position) {
  DeformablePosition<QueryPosition<uint16_t>> to;
  to.position.a = position.position.a;
  to.position.b = position.position.b;
  to.position.untested = position.position.untested;
  to.position.state = static_cast<QueryPosition<uint16_t>::State>(position.position.state);
  to.refits = position.refits;
  return c_status(query.resume(to));
}

}  // namespace flashbvh

uint32_t flashbvh_mesh_nodes(const flashbvh_mesh* mesh) {
  return object_in(mesh).node_count;
}

uint32_t flashbvh_mesh_vertices(const flashbvh_mesh* mesh) {
  return object_in(mesh).vertex_count;
}

void flashbvh_deformable_make(flashbvh_deformable* deformable, const flashbvh_mesh* baked,
                              flashbvh_node* nodes, flashbvh_vertex* vertices) {
  new (Storage{reinterpret_cast<unsigned char*>(deformable)})
      DeformableMesh(object_in(baked), reinterpret_cast<Node<uint16_t>*>(nodes),
                     reinterpret_cast<Vertex*>(vertices));
}

flashbvh_status flashbvh_deformable_refit(flashbvh_deformable* deformable, uint32_t work,
                                          uint32_t* vertex) {
  const RefitStep step = object_in(deformable).refit(work);
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
  new (storage_of<DeformableSelfQuery>(query)) DeformableSelfQuery(object_in(deformable));
  return c_status(object_in(query).status());
}

flashbvh_status flashbvh_self_query_run(flashbvh_self_query* query, uint32_t work,
                                        flashbvh_pair* pairs, uint32_t capacity, uint32_t* count) {
  return run_self(object_in(query), work, pairs, capacity, count);
}

flashbvh_counts flashbvh_self_query_counts(const flashbvh_self_query* query) {
  return c_counts(object_in(query).query().counts());
}

flashbvh_self_position flashbvh_self_query_position(const flashbvh_self_query* query) {
  return self_position(object_in(query));
}

flashbvh_status flashbvh_self_query_resume(flashbvh_self_query* query,
                                           const flashbvh_self_position* position) {
  return resume_self(object_in(query), *position);
}

flashbvh_status flashbvh_self_within_start(flashbvh_self_within_query* query,
                                           const flashbvh_deformable* deformable,
                                           uint32_t distance) {
  new (storage_of<DeformableBand>(query)) DeformableBand(object_in(deformable), within(distance));
  return c_status(object_in(query).status());
}

flashbvh_status flashbvh_self_within_run(flashbvh_self_within_query* query, uint32_t work,
                                         flashbvh_pair* pairs, uint32_t capacity, uint32_t* count) {
  return run_self(object_in(query), work, pairs, capacity, count);
}

flashbvh_counts flashbvh_self_within_counts(const flashbvh_self_within_query* query) {
  return c_counts(object_in(query).query().counts());
}

flashbvh_self_position flashbvh_self_within_position(const flashbvh_self_within_query* query) {
  return self_position(object_in(query));
}

flashbvh_status flashbvh_self_within_resume(flashbvh_self_within_query* query,
                                            const flashbvh_self_position* position) {
  return resume_self(object_in(query), *position);
}

flashbvh_status flashbvh_intersects_itself(const flashbvh_mesh* mesh, bool* yes) {
  const Answer answer = intersects_itself(object_in(mesh));
  *yes = answer.yes;
  return c_status(answer.status);
}
