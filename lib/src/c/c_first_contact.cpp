// The C interface to motions of two bodies.
#include "flashbvh/first_contact.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_body_motion, BodyMotion);
FLASHBVH_HOLDS(flashbvh_first_contact_query, FirstContact);

static_assert(FLASHBVH_MOTION_END == kMotionEnd &&
                  FLASHBVH_MAX_MOTION_DISTANCE == kMaxMotionDistance,
              "as in C++");

flashbvh_status flashbvh_body_motion_between(const flashbvh_pose* from, const flashbvh_pose* to,
                                             flashbvh_body_motion* motion) {
  return c_status(make(motion, BodyMotion::between(object_in(from), object_in(to))).status());
}

flashbvh_status flashbvh_first_contact_start(flashbvh_first_contact_query* query,
                                             const flashbvh_mesh* a, const flashbvh_mesh* b,
                                             const flashbvh_body_motion* motion,
                                             flashbvh_fine_length within) {
  return c_status(make(query, object_in(a), object_in(b), object_in(motion), within).status());
}

flashbvh_first_contact_answer flashbvh_first_contact_run(flashbvh_first_contact_query* query,
                                                         uint32_t work) {
  return object_in(query).run(work);
}
