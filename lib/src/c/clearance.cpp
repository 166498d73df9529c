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

WithinQuery& query_in(flashbvh_within_query* query) {
  return *reinterpret_cast<WithinQuery*>(query->opaque.bytes);
}
const WithinQuery& query_in(const flashbvh_within_query* query) {
  return *reinterpret_cast<const WithinQuery*>(query->opaque.bytes);
}

Seed seed_of(const flashbvh_witness* seed) {
  return seed == nullptr ? Seed() : Seed{seed->a, seed->b};
}

flashbvh_fine_point fine_point_of(const FinePoint& p) {
  return {p.x, p.y, p.z};
}

QueryPosition<uint16_t> position_of(const flashbvh_position& position) {
  QueryPosition<uint16_t> to;
  to.a = position.a;
  to.b = position.b;
  to.untested = position.untested;
  to.state = static_cast<QueryPosition<uint16_t>::State>(position.state);
  return to;
}

void put(const NearestPoints& found, flashbvh_nearest_points* nearest) {
  *nearest = {fine_point_of(found.point_a),
              fine_point_of(found.point_b),
              {found.direction.x, found.direction.y, found.direction.z},
              found.lower,
              found.upper};
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
  return c_counts(query_in(query).counts());
}

flashbvh_clearance_position flashbvh_clearance_position_of(const flashbvh_clearance_query* query) {
  const ClearancePosition<uint16_t> position = query_in(query).position();
  return {
      c_position(position.walk), {position.witness.a, position.witness.b}, position.has_witness};
}

flashbvh_status flashbvh_clearance_resume(flashbvh_clearance_query* query,
                                          const flashbvh_clearance_position* position) {
  ClearancePosition<uint16_t> to;
  to.walk = position_of(position->walk);
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

flashbvh_status flashbvh_within_start(flashbvh_within_query* query, const flashbvh_mesh* a,
                                      const flashbvh_mesh* b, const flashbvh_pose* pose,
                                      uint32_t distance) {
  new (storage_of<WithinQuery>(query))
      WithinQuery(object_in(a), object_in(b), object_in(pose), {}, within(distance));
  return c_status(query_in(query).status());
}

flashbvh_status flashbvh_within_status(const flashbvh_within_query* query) {
  return c_status(query_in(query).status());
}

flashbvh_status flashbvh_within_run(flashbvh_within_query* query, uint32_t work,
                                    flashbvh_pair* pairs, uint32_t capacity, uint32_t* count) {
  return c_status(run_into(query_in(query), work, pairs, capacity, *count));
}

flashbvh_status flashbvh_within_spend(flashbvh_within_query* query, uint32_t* work,
                                      flashbvh_pair* pairs, uint32_t capacity, uint32_t* count) {
  return c_status(run_into(query_in(query), *work, pairs, capacity, *count));
}

flashbvh_status flashbvh_within_visit(flashbvh_within_query* query, uint32_t* work,
                                      flashbvh_visitor* visit, void* context) {
  return c_status(query_in(query).spend(*work, [visit, context](const WithinQuery::Pair& pair) {
    return visit(c_pair(pair), context);
  }));
}

flashbvh_counts flashbvh_within_counts(const flashbvh_within_query* query) {
  return c_counts(query_in(query).counts());
}

flashbvh_position flashbvh_within_position(const flashbvh_within_query* query) {
  return c_position(query_in(query).position());
}

flashbvh_status flashbvh_within_resume(flashbvh_within_query* query,
                                       const flashbvh_position* position) {
  return c_status(query_in(query).resume(position_of(*position)));
}

void flashbvh_within_last_pair(const flashbvh_within_query* query, flashbvh_triangle* a,
                               flashbvh_triangle* b) {
  Triangle placed_a;
  Triangle placed_b;
  query_in(query).last_pair(placed_a, placed_b);
  put(placed_a, a);
  put(placed_b, b);
}

void flashbvh_within_last_nearest_points(const flashbvh_within_query* query,
                                         flashbvh_nearest_points* nearest) {
  Triangle a;
  Triangle b;
  query_in(query).last_pair(a, b);
  put(nearest_points_of(a, b), nearest);
}

void flashbvh_nearest_points_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                                flashbvh_nearest_points* nearest) {
  put(nearest_points_of(triangle_of(*a), triangle_of(*b)), nearest);
}

flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                         const flashbvh_pose* pose, uint32_t distance,
                                         flashbvh_visitor* visit, void* context) {
  WithinQuery query(object_in(a), object_in(b), object_in(pose), {}, within(distance));
  return c_status(query.run(UINT32_MAX, [visit, context](const WithinQuery::Pair& pair) {
    return visit({pair.a, pair.b}, context);
  }));
}
