// The C interface to certified motions.
#include "flashbvh/robot/motion.hpp"

#include "robot_objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_MOTION_HIT == static_cast<int>(MotionOutcome::hit) &&
                  FLASHBVH_MOTION_CLOSE == static_cast<int>(MotionOutcome::close),
              "one list of outcomes");
static_assert(FLASHBVH_MOTION_STATE_SIZE(1, 1) == sizeof(MotionStateOf<1, 1>) &&
                  FLASHBVH_MOTION_STATE_SIZE(6, 1) == sizeof(MotionStateOf<6, 1>) &&
                  FLASHBVH_MOTION_STATE_SIZE(6, 7) == sizeof(MotionStateOf<6, 7>),
              "one size of a state");

namespace {

MotionQuery& motion_in(flashbvh_motion* motion) {
  return *reinterpret_cast<MotionQuery*>(motion->opaque.bytes);
}
const MotionQuery& motion_in(const flashbvh_motion* motion) {
  return *reinterpret_cast<const MotionQuery*>(motion->opaque.bytes);
}

}  // namespace

flashbvh_status flashbvh_motion_init(flashbvh_motion* motion, const flashbvh_robot* robot,
                                     void* state, size_t size) {
  new (storage_of<MotionQuery>(motion)) MotionQuery(object_in(robot), state, size);
  return c_status(motion_in(motion).fits() ? Status::done : Status::guard_state_invalid);
}

flashbvh_status flashbvh_motion_start(flashbvh_motion* motion,
                                      const flashbvh_joint_coordinate* from,
                                      const flashbvh_joint_coordinate* to) {
  return c_status(motion_in(motion).start(from, to));
}

flashbvh_motion_answer flashbvh_motion_run(flashbvh_motion* motion, uint32_t work) {
  const MotionAnswer answer = motion_in(motion).run(work);
  return {static_cast<uint8_t>(answer.status),
          static_cast<uint8_t>(answer.outcome),
          answer.pair,
          {answer.triangles.a, answer.triangles.b},
          answer.numerator,
          answer.level};
}

void flashbvh_motion_set_values(const flashbvh_motion* motion, uint32_t numerator, uint8_t level,
                                flashbvh_joint_coordinate* values) {
  motion_in(motion).set_values(numerator, level, values);
}
