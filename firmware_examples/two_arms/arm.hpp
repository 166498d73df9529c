// Motions of two arms on a turning torso, from waypoint to waypoint.
#pragma once

#include "motion.hpp"
#include "two_arms.robot.h"

/// A name in the robot's header.
#define ARM(name) two_arms_##name

/// 1 kHz on a core of 168 MHz.
constexpr uint32_t kInstructionsAPeriod = 168000;
/// Work per period, in units of query.hpp.
constexpr uint32_t kWork = 500;

/// Order of joints: the torso; shoulder, elbow and wrist of the left arm; then of the right arm.
constexpr Waypoint kAtRest = {{0, 1, 0, 0, 1, 0, 0}};
constexpr Waypoint kReady = {{0.6f, -0.3f, 0.3f, 0, 0.6f, 0.3f, 0}};
constexpr Waypoint kOneOverTheOther = {{-0.4f, -0.05f, 1.3f, 0, 0.25f, 1.3f, 1.5f}};
constexpr Waypoint kHandInHand = {{0, 0.2f, 0.7f, 1.5f, 0.2f, 0.7f, 0}};
constexpr Waypoint kHandOnTheOtherArm = {{0.3f, 0.1f, 1.9f, 0, 0.3f, 0, 0}};

constexpr Motion kMotions[] = {
    {"from rest to ready", kAtRest, kReady, 1500, false},
    {"one arm over the other", kReady, kOneOverTheOther, 1500, false},
    {"and back", kOneOverTheOther, kReady, 1200, false},
    {"hand in hand", kReady, kHandInHand, 1200, true},
    {"a hand on the other arm", kReady, kHandOnTheOtherArm, 1500, true},
};
