// The arm's joints and its forward kinematics: the links' poses at given angles, in float.
#pragma once

#include <flashbvh/pose.hpp>

constexpr int kJointCount = 6;
constexpr int kLinkCount = kJointCount + 1;

/// A joint that rotates the next link in the previous link's frame.
struct Joint {
  float origin[3];  ///< metres
  float axis[3];    ///< of length 1
  float least;      ///< radians, like all angles
  float most;
};

/// Each link's pose in the frame of the first link.
struct ArmPose {
  flashbvh::Pose link[kLinkCount];
};

/// The links' poses at these joint angles. Takes 104 bytes per link.
ArmPose arm_pose(const float (&angles)[kJointCount]);
