// The C interface to the self-test of guards.
#include "flashbvh/robot.h"
#include "flashbvh/robot/self_test.hpp"
#include "objects.hpp"

flashbvh_status flashbvh_test_known_guard(void) {
  return flashbvh::c_status(flashbvh::test_known_guard());
}
