// The C interface to guards.
#include "flashbvh/robot.h"
#include "flashbvh/robot/guard.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_guard, Guard);

static_assert(FLASHBVH_NO_PAIR == kNoPair && FLASHBVH_NO_VARIABLE == kNoVariable,
              "one meaning of none");
static_assert(FLASHBVH_GUARD_STATE_SIZE(1, 1, 1) == sizeof(GuardStateOf<1, 1, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(7, 1, 1) == sizeof(GuardStateOf<7, 1, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(1, 9, 1) == sizeof(GuardStateOf<1, 9, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(7, 9, 20) == sizeof(GuardStateOf<7, 9, 20>),
              "one size of a state");

flashbvh_status flashbvh_guard_init(flashbvh_guard* guard, const flashbvh_robot* robot, void* state,
                                    size_t size) {
  return c_status(make(guard, *robot, state, size).status());
}

flashbvh_guard_answer flashbvh_guard_update(flashbvh_guard* guard,
                                            const flashbvh_joint_coordinate* values,
                                            uint32_t work) {
  return object_in(guard).update(values, work);
}

flashbvh_guard_answer flashbvh_guard_go_on(flashbvh_guard* guard, uint32_t work) {
  return object_in(guard).go_on(work);
}
