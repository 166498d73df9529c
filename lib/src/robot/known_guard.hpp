// Motion of the known-answer test of guards.
#ifndef FLASHBVH_ROBOT_KNOWN_GUARD_HPP
#define FLASHBVH_ROBOT_KNOWN_GUARD_HPP

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Both joints move towards the wall at constant speed.
constexpr JointCoordinate kKnownStart[2] = {-kFullTurn / 6, 2'500'000};
constexpr JointCoordinate kKnownStep[2] = {kFullTurn / 200, 165'000};
constexpr int kKnownPeriods = 44;
constexpr uint32_t kKnownWork = 150;

uint32_t known_guard_digest();

}  // namespace flashbvh::detail

#endif
