// The C interface to distances.
#include "flashbvh/clearance.h"
#include "flashbvh/clearance.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_clearance_query, ClearanceQuery);
FLASHBVH_HOLDS(flashbvh_within_query, WithinQuery);

namespace {

using Hint = ClearanceQuery::Hint;

Hint hint_in(const flashbvh_witness* hint) {
  return hint == nullptr ? Hint() : Hint{hint->a, hint->b};
}

template <class Coordinates>
void put(const Coordinates& from, Coordinates& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}

/// Copies number by number, which takes the least stack.
void put(const Clearance<uint16_t>& known, flashbvh_clearance* result) {
  put(known.point_a, result->point_a);
  put(known.point_b, result->point_b);
  put(known.direction, result->direction);
  result->lower = known.lower;
  result->upper = known.upper;
  result->triangles = known.triangles;
  result->witness = {known.witness.a, known.witness.b};
  result->status = c_status(known.status);
  result->in_range = known.in_range;
}

}  // namespace

flashbvh_status flashbvh_clearance_start(flashbvh_clearance_query* query, const flashbvh_mesh* a,
                                         const flashbvh_mesh* b, const flashbvh_pose* pose,
                                         const flashbvh_clearance_options* options) {
  ClearanceQuery::Options with;
  if (options != nullptr) {
    with = {hint_in(options->hint), options->tolerance};
  }
  return c_status(make(query, object_in(a), object_in(b), object_in(pose), with).status());
}

flashbvh_status flashbvh_clearance_run(flashbvh_clearance_query* query, uint32_t* work) {
  return c_status(object_in(query).run_within(*work));
}

void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result) {
  put(object_in(query).result(), result);
}

flashbvh_stats flashbvh_clearance_stats(const flashbvh_clearance_query* query) {
  return object_in(query).stats();
}

flashbvh_cursor flashbvh_clearance_cursor(const flashbvh_clearance_query* query) {
  return object_in(query).cursor();
}

flashbvh_status flashbvh_clearance_resume(flashbvh_clearance_query* query,
                                          const flashbvh_cursor* cursor) {
  return c_status(object_in(query).resume(*cursor));
}

flashbvh_status flashbvh_distance(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                  const flashbvh_pose* pose, const flashbvh_witness* hint,
                                  flashbvh_clearance* result) {
  put(distance(object_in(a), object_in(b), object_in(pose), hint_in(hint)), result);
  return result->status;
}

flashbvh_status flashbvh_closer_than(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                     const flashbvh_pose* pose, flashbvh_fine_length distance,
                                     bool* yes) {
  return put_answer(closer_than(object_in(a), object_in(b), object_in(pose), distance), yes);
}

flashbvh_status flashbvh_within_start(flashbvh_within_query* query, const flashbvh_mesh* a,
                                      const flashbvh_mesh* b, const flashbvh_pose* pose,
                                      flashbvh_fine_length distance) {
  return c_status(make(query, object_in(a), object_in(b), object_in(pose), WithinQuery::Cursor(),
                       within(distance))
                      .status());
}

flashbvh_status flashbvh_within_status(const flashbvh_within_query* query) {
  return c_status(object_in(query).status());
}

flashbvh_run_result flashbvh_within_run(flashbvh_within_query* query, uint32_t work,
                                        flashbvh_pair* pairs, uint32_t capacity) {
  return object_in(query).run(work, pairs, capacity);
}

flashbvh_run_result flashbvh_within_visit(flashbvh_within_query* query, uint32_t work,
                                          flashbvh_visitor* visit, void* context) {
  return object_in(query).run(
      work, [visit, context](const flashbvh_pair& pair) { return visit(pair, context); });
}

flashbvh_stats flashbvh_within_stats(const flashbvh_within_query* query) {
  return object_in(query).stats();
}

flashbvh_cursor flashbvh_within_cursor(const flashbvh_within_query* query) {
  return object_in(query).cursor();
}

flashbvh_status flashbvh_within_resume(flashbvh_within_query* query,
                                       const flashbvh_cursor* cursor) {
  return c_status(object_in(query).resume(*cursor));
}

void flashbvh_within_last_pair(const flashbvh_within_query* query, flashbvh_triangle* a,
                               flashbvh_triangle* b) {
  object_in(query).last_pair(*a, *b);
}

void flashbvh_within_last_nearest_points(const flashbvh_within_query* query,
                                         flashbvh_nearest_points* nearest) {
  Triangle a;
  Triangle b;
  object_in(query).last_pair(a, b);
  put(nearest, [&] { return nearest_points_of(a, b); });
}

void flashbvh_nearest_points_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                                flashbvh_nearest_points* nearest) {
  put(nearest, [&] { return nearest_points_of(*a, *b); });
}

flashbvh_status flashbvh_for_each_within(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                         const flashbvh_pose* pose, flashbvh_fine_length distance,
                                         flashbvh_visitor* visit, void* context) {
  WithinQuery query(object_in(a), object_in(b), object_in(pose), {}, within(distance));
  const RunResult step = query.run(
      UINT32_MAX, [visit, context](const flashbvh_pair& pair) { return visit(pair, context); });
  return c_status(step.status);
}
