// What the arm is told to do: from rest to rest, all joints in proportion.
#ifndef FLASHBVH_ROBOT_GUARD_MOTIONS_HPP
#define FLASHBVH_ROBOT_GUARD_MOTIONS_HPP

#include <flashbvh/robot/guard.hpp>

#include "cell_arm.robot.hpp"

struct Motion {
  const char* name;
  float from[cell_arm::kVariableCount];  ///< turn, shoulder, elbow, roll, in radians
  float to[cell_arm::kVariableCount];
  int milliseconds;
  flashbvh::Verdict end;
};

constexpr Motion kMotions[] = {
    {"from side to side",
     {-1.2f, 0.5f, 1, 0},
     {1.2f, 0.3f, 1.3f, 7},
     1500,
     flashbvh::Verdict::free},
    {"folded into itself",
     {0, 0, 0.5f, 1.5f},
     {0, 0.2f, 2.9f, 1.5f},
     1500,
     flashbvh::Verdict::stop},
    {"into the fence", {-0.6f, 0.5f, 1, 0}, {0.3f, 1.2f, 0.5f, 0}, 1200, flashbvh::Verdict::stop},
};

/// Where the joints are to be after so many milliseconds: a cubic, which begins and ends at rest.
inline void set_point(const Motion& motion, int millisecond, float* joints) {
  const float time = static_cast<float>(millisecond) / static_cast<float>(motion.milliseconds);
  const float way = time * time * (3 - 2 * time);
  for (uint32_t i = 0; i < cell_arm::kVariableCount; ++i) {
    joints[i] = motion.from[i] + way * (motion.to[i] - motion.from[i]);
  }
}

#endif
