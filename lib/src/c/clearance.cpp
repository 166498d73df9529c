// The C interface to distances.
#include "flashbvh/clearance.hpp"

#include "flashbvh/clearance.h"
#include "objects.hpp"

using namespace flashbvh;

namespace {

using Seed = ClearanceQuery::Seed;

ClearanceQuery& query_in(flashbvh_clearance_query* query) {
  return *reinterpret_cast<ClearanceQuery*>(query->opaque.bytes);
}
const ClearanceQuery& query_in(const flashbvh_clearance_query* query) {
  return *reinterpret_cast<const ClearanceQuery*>(query->opaque.bytes);
}

Seed seed_of(const flashbvh_witness* seed) {
  return seed == nullptr ? Seed() : Seed{seed->a, seed->b};
}

flashbvh_fine_point fine_point_of(const FinePoint& p) {
  return {p.x, p.y, p.z};
}

flashbvh_clearance clearance_of(const Clearance<uint16_t>& known) {
  return {fine_point_of(known.point_a),
          fine_point_of(known.point_b),
          {known.direction.x, known.direction.y, known.direction.z},
          known.lower,
          known.upper,
          {known.triangles.a, known.triangles.b},
          {known.witness.a, known.witness.b},
          c_status(known.status),
          known.in_range};
}

}  // namespace

flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_witness* seed, uint16_t tolerance) {
  new (storage_of<ClearanceQuery>(query))
      ClearanceQuery(object_in(a), object_in(b), object_in(pose), seed_of(seed), tolerance);
  return c_status(query_in(query).status());
}

flashbvh_status flashbvh_clearance_spend(flashbvh_clearance_query* query, uint32_t* work) {
  return c_status(query_in(query).spend(*work));
}

void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result) {
  *result = clearance_of(query_in(query).result());
}

flashbvh_counts flashbvh_clearance_counts(const flashbvh_clearance_query* query) {
  const Counts& counts = query_in(query).counts();
  return {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
}

flashbvh_clearance_position flashbvh_clearance_position_of(const flashbvh_clearance_query* query) {
  const ClearancePosition<uint16_t> position = query_in(query).position();
  const QueryPosition<uint16_t>& walk = position.walk;
  return {{walk.a, walk.b, walk.untested, static_cast<uint8_t>(walk.state), {0, 0, 0}},
          {position.witness.a, position.witness.b},
          position.has_witness};
}

flashbvh_status flashbvh_clearance_resume(flashbvh_clearance_query* query,
                                          const flashbvh_clearance_position* position) {
  ClearancePosition<uint16_t> to;
  to.walk.a = position->walk.a;
  to.walk.b = position->walk.b;
  to.walk.untested = position->walk.untested;
  to.walk.state = static_cast<QueryPosition<uint16_t>::State>(position->walk.state);
  to.witness = seed_of(&position->witness);
  to.has_witness = position->has_witness;
  return c_status(query_in(query).resume(to));
}

flashbvh_status flashbvh_distance(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                  const flashbvh_pose* pose, const flashbvh_witness* seed,
                                  flashbvh_clearance* result) {
  *result = clearance_of(distance(object_in(a), object_in(b), object_in(pose), seed_of(seed)));
  return result->status;
}

flashbvh_status flashbvh_closer_than(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                     const flashbvh_pose* pose, uint32_t distance, bool* yes) {
  const Answer answer = closer_than(object_in(a), object_in(b), object_in(pose), distance);
  *yes = answer.yes;
  return c_status(answer.status);
}

flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                         const flashbvh_pose* pose, uint32_t distance,
                                         flashbvh_visitor* visit, void* context) {
  WithinQuery query(object_in(a), object_in(b), object_in(pose), {}, within(distance));
  return c_status(query.run(UINT32_MAX, [visit, context](const WithinQuery::Pair& pair) {
    return visit({pair.a, pair.b}, context);
  }));
}
