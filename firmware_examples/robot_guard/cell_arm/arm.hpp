// Motions of a small arm with a gripper, on a pedestal behind a fence.
#pragma once

#include "cell_arm.robot.h"
#include "motion.hpp"

/// A name in the robot's header.
#define ARM(name) cell_arm_##name

/// 1 kHz on a small core of 96 MHz.
constexpr uint32_t kInstructionsAPeriod = 96000;
/// Work per period, in units of query.hpp.
constexpr uint32_t kWork = 150;

constexpr Motion kMotions[] = {
    {"from side to side", {-1.2f, 0.5f, 1, 0}, {1.2f, 0.3f, 1.3f, 7}, 1500, false},
    {"folded into itself", {0, 0, 0.5f, 1.5f}, {0, 0.2f, 2.9f, 1.5f}, 1500, true},
    {"into the fence", {-0.6f, 0.5f, 1, 0}, {0.3f, 1.2f, 0.5f, 0}, 1200, true},
    {"away from the fence", {-0.146f, 0.853f, 0.748f, 0}, {-0.6f, 0.5f, 1, 0}, 1200, false},
};
