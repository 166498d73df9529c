// The motion of the known-answer test of guards.
#ifndef FLASHBVH_ROBOT_KNOWN_GUARD_HPP
#define FLASHBVH_ROBOT_KNOWN_GUARD_HPP

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Both joints go to the wall at a constant speed, from a turn and no slide on.
constexpr JointCoordinate kKnownTurn = -kFullTurn / 4;
constexpr JointCoordinate kKnownTurnStep = kFullTurn / 100;
constexpr JointCoordinate kKnownSlideStep = 300'000;
constexpr int kKnownPeriods = 26;
constexpr uint32_t kKnownWork = 150;

uint32_t known_guard_digest();

}  // namespace flashbvh::detail

#endif
