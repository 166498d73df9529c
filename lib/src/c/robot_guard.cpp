// The C interface to guards.
#include "flashbvh/robot/guard.hpp"

#include "robot_objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_NO_PAIR == kNoPair && FLASHBVH_NO_VARIABLE == kNoVariable,
              "one meaning of none");
static_assert(FLASHBVH_VERDICT_WARN == static_cast<int>(Verdict::warn) &&
                  FLASHBVH_VERDICT_NOT_YET_KNOWN == static_cast<int>(Verdict::not_yet_known) &&
                  FLASHBVH_VERDICT_STOP == static_cast<int>(Verdict::stop) &&
                  FLASHBVH_VERDICT_REFUSED == static_cast<int>(Verdict::refused),
              "one list of verdicts");
static_assert(FLASHBVH_GUARD_STATE_SIZE(1, 1, 1) == sizeof(GuardStateOf<1, 1, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(7, 1, 1) == sizeof(GuardStateOf<7, 1, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(1, 9, 1) == sizeof(GuardStateOf<1, 9, 1>) &&
                  FLASHBVH_GUARD_STATE_SIZE(7, 9, 20) == sizeof(GuardStateOf<7, 9, 20>),
              "one size of a state");

namespace {

Guard& guard_in(flashbvh_guard* guard) {
  return *reinterpret_cast<Guard*>(guard->opaque.bytes);
}

constexpr flashbvh_guard_answer c_answer(const GuardAnswer& answer) {
  return {static_cast<uint8_t>(answer.status), static_cast<uint8_t>(answer.verdict), answer.pair,
          answer.distance, answer.work};
}

}  // namespace

flashbvh_status flashbvh_guard_init(flashbvh_guard* guard, const flashbvh_robot* robot, void* state,
                                    size_t size) {
  new (storage_of<Guard>(guard)) Guard(object_in(robot), state, size);
  return c_status(guard_in(guard).fits() ? Status::done : Status::guard_state_invalid);
}

void flashbvh_guard_forget(flashbvh_guard* guard) {
  guard_in(guard).forget();
}

flashbvh_status flashbvh_guard_resume(flashbvh_guard* guard) {
  return c_status(guard_in(guard).resume());
}

flashbvh_guard_answer flashbvh_guard_update(flashbvh_guard* guard,
                                            const flashbvh_joint_coordinate* values,
                                            uint32_t work) {
  return c_answer(guard_in(guard).update(values, work));
}

flashbvh_guard_answer flashbvh_guard_go_on(flashbvh_guard* guard, uint32_t work) {
  return c_answer(guard_in(guard).go_on(work));
}

flashbvh_guard_answer flashbvh_guard_prime(flashbvh_guard* guard,
                                           const flashbvh_joint_coordinate* values) {
  return c_answer(guard_in(guard).prime(values));
}
