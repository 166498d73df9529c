// The arm's joints, and where its links are at given angles: forward kinematics, in float.
#ifndef ROBOT_ARM_ARM_HPP
#define ROBOT_ARM_ARM_HPP

#include <flashbvh/pose.hpp>

constexpr int kJointCount = 6;
constexpr int kLinkCount = kJointCount + 1;

/// A joint that rotates the next link in the frame of the one before.
struct Joint {
  float origin[3];  ///< metres
  float axis[3];    ///< of length 1
  float least;      ///< radians, as all angles
  float most;
};

/// Each link in the frame of the first.
struct ArmPose {
  flashbvh::Pose link[kLinkCount];
};

/// The links where the joints are at these angles. Takes 104 bytes a link.
ArmPose arm_pose(const float (&angles)[kJointCount]);

#endif
