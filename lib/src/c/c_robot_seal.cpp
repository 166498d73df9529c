// The C interface to sealed guards, in a file of its own: other firmware links no checksums.
#include "flashbvh/robot.h"
#include "flashbvh/robot/guard.hpp"
#include "objects.hpp"

using namespace flashbvh;

void flashbvh_guard_seal(flashbvh_guard* guard) {
  reinterpret_cast<Guard*>(guard)->seal();
}

flashbvh_status flashbvh_guard_verify(const flashbvh_guard* guard) {
  return c_status(reinterpret_cast<const Guard*>(guard)->verify());
}
