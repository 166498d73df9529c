// Motions of an arm: from rest to rest, all joints in proportion.
#pragma once

#include <stdint.h>

constexpr uint32_t kMostVariables = 7;

struct Waypoint {
  float joints[kMostVariables];  ///< in radians
};

struct Motion {
  const char* name;
  Waypoint from;
  Waypoint to;
  int milliseconds;
  bool stops;  ///< the guard holds the arm on the way
};

/// Joint values after so many milliseconds, on a cubic that begins and ends at rest.
inline void set_point(const Motion& motion, int millisecond, float* joints) {
  const float time = static_cast<float>(millisecond) / static_cast<float>(motion.milliseconds);
  const float way = time * time * (3 - 2 * time);
  for (uint32_t i = 0; i < kMostVariables; ++i) {
    const float from = motion.from.joints[i];
    joints[i] = from + way * (motion.to.joints[i] - from);
  }
}
