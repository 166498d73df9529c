// Motions of a KUKA KR5 on a pedestal, behind a fence.
#pragma once

#include "kr5_cell.robot.h"
#include "motion.hpp"

/// A name in the robot's header.
#define ARM(name) kr5_cell_##name

/// 1 kHz on a core of 168 MHz.
constexpr uint32_t kInstructionsAPeriod = 168000;
/// Work per period, in units of query.hpp.
constexpr uint32_t kWork = 500;

/// Yaw and pitch of the shoulder, pitch and roll of the elbow, pitch and roll of the wrist.
constexpr Motion kMotions[] = {
    {"from side to side",
     {-2, -0.2f, -0.6f, 0, 0.5f, 0},
     {2, -0.4f, -0.3f, 0.3f, -0.5f, 3},
     3000,
     false},
    {"folded into itself",
     {0, -0.2f, -1, 0, 0, 0},
     {0.2f, -0.6f, -3.6f, -0.07f, -1.4f, 1.6f},
     3000,
     true},
    {"into the fence", {-1, -0.3f, -0.6f, 0, 0.5f, 0}, {0.3f, 0.9f, -0.9f, 0, 0.3f, 1}, 2000, true},
    // 10,000 random configurations mostly miss this collision.
    {"bicep and forearm", {0, 0.3f, -2.5f, 0, 0, 0}, {0, 0.3f, -3.64f, -0.1f, 0, 0}, 2000, true},
};
