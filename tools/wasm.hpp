// Shared by the WebAssembly modules of pages.
#pragma once

#include <stdint.h>

#include "flashbvh/robot.h"

#define EXPORT extern "C" __attribute__((visibility("default"), used))

namespace wasm {

/// The length of a cell from its bits.
inline double length_of(uint64_t bits) {
  double length = 0;
  __builtin_memcpy(&length, &bits, sizeof length);
  return length;
}

/// The first joint that a value moves directly.
inline uint32_t joint_of(const flashbvh_robot& robot, uint32_t variable) {
  uint32_t joint = 0;
  while (robot.joints[joint].variable != variable || robot.joints[joint].shift != 0 ||
         robot.joints[joint].type == flashbvh::JointType{FLASHBVH_JOINT_FIXED}) {
    ++joint;
  }
  return joint;
}

}  // namespace wasm
