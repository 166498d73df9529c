// The C interface to motions of two bodies.
#include "flashbvh/first_contact.h"
#include "flashbvh/first_contact.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_body_motion, BodyMotion);
FLASHBVH_HOLDS(flashbvh_first_contact_query, FirstContact);
FLASHBVH_HOLDS(flashbvh_contact_cursor, FirstContact::Cursor);

static_assert(FLASHBVH_MOTION_END == kMotionEnd && FLASHBVH_MOST_MOVES == kMostMoves, "as in C++");

flashbvh_status flashbvh_body_motion_between(const flashbvh_pose* from, const flashbvh_pose* to,
                                             flashbvh_body_motion* motion) {
  return c_status(make(motion, BodyMotion::between(object_in(from), object_in(to))).status());
}

flashbvh_status flashbvh_body_motion_of_moves(const flashbvh_pose* from, const flashbvh_move* moves,
                                              uint32_t count, flashbvh_body_motion* motion) {
  return c_status(make(motion, object_in(from), moves, count).status());
}

flashbvh_status flashbvh_body_motion_pose(const flashbvh_body_motion* motion, uint32_t time,
                                          flashbvh_pose* pose) {
  return put_pose(object_in(motion).pose_at(time), pose);
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

void flashbvh_first_contact_pass(flashbvh_first_contact_query* query) {
  object_in(query).pass();
}

flashbvh_contact_cursor flashbvh_first_contact_cursor(const flashbvh_first_contact_query* query) {
  flashbvh_contact_cursor cursor;
  make(&cursor, object_in(query).cursor());
  return cursor;
}

flashbvh_status flashbvh_first_contact_resume(flashbvh_first_contact_query* query,
                                              const flashbvh_contact_cursor* cursor) {
  return c_status(object_in(query).resume(object_in(cursor)));
}
