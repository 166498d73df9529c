// The C interface to distances.
#include "flashbvh/clearance.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_clearance_query, ClearanceQuery);

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
                                         const flashbvh_witness* hint) {
  return c_status(make(query, object_in(a), object_in(b), object_in(pose), hint_in(hint)).status());
}

flashbvh_status flashbvh_clearance_run(flashbvh_clearance_query* query, uint32_t* work) {
  return c_status(object_in(query).run_within(*work));
}

void flashbvh_clearance_result(const flashbvh_clearance_query* query, flashbvh_clearance* result) {
  put(object_in(query).result(), result);
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
