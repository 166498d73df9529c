// The C interface to commands of a guard, in a file of its own: it is linked only if it is called.
#include "flashbvh/robot.h"
#include "flashbvh/robot/guard.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_limit_answer flashbvh_guard_limit(flashbvh_guard* guard,
                                           const flashbvh_joint_coordinate* wanted,
                                           flashbvh_joint_coordinate* granted, uint32_t work) {
  return reinterpret_cast<Guard*>(guard)->limit(wanted, granted, work);
}

flashbvh_status flashbvh_guard_release(flashbvh_guard* guard, uint16_t pair,
                                       flashbvh_fine_length a_command) {
  return c_status(reinterpret_cast<Guard*>(guard)->release(pair, a_command));
}
