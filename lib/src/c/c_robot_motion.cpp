// The C interface to certified motions.
#include "flashbvh/robot.h"
#include "flashbvh/robot/motion.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_motion, MotionQuery);

static_assert(FLASHBVH_MOTION_STATE_SIZE(1, 1) == sizeof(MotionStateOf<1, 1>) &&
                  FLASHBVH_MOTION_STATE_SIZE(6, 1) == sizeof(MotionStateOf<6, 1>) &&
                  FLASHBVH_MOTION_STATE_SIZE(6, 7) == sizeof(MotionStateOf<6, 7>),
              "one size of a state");

flashbvh_status flashbvh_motion_init(flashbvh_motion* motion, const flashbvh_robot* robot,
                                     void* state, size_t size) {
  return c_status(make(motion, *robot, state, size).status());
}

flashbvh_status flashbvh_motion_start(flashbvh_motion* motion,
                                      const flashbvh_joint_coordinate* from,
                                      const flashbvh_joint_coordinate* to) {
  return c_status(object_in(motion).start(from, to));
}

flashbvh_motion_answer flashbvh_motion_run(flashbvh_motion* motion, uint32_t work) {
  return object_in(motion).run(work);
}
