// The known-answer test of guards; self_test.hpp has the tests of meshes.
#ifndef FLASHBVH_ROBOT_SELF_TEST_HPP
#define FLASHBVH_ROBOT_SELF_TEST_HPP

#include "flashbvh/status.hpp"

namespace flashbvh {

/// Tests kinematics, the guard and its measurements on a small built-in robot: `done` or
/// `self_test_failed`. 2,100,000 instructions on a Cortex-M4F at -O2; 1,792 bytes of stack.
Status test_known_guard();

}  // namespace flashbvh

#endif
