#include "arm.hpp"

#include <math.h>

#include <flashbvh/float.hpp>

#include "joints.hpp"
#include "palm.fbvh.h"

using namespace flashbvh;

namespace {

constexpr Pose kIdentity = Pose::translated(0, 0, 0);

/// The next link's pose in the previous link's frame. All links share a cell.
Pose rotated(const Joint& joint, float angle) {
  const float sine = sinf(angle / 2);
  return pose_of(UnitQuaternion{cosf(angle / 2), joint.axis[0] * sine, joint.axis[1] * sine,
                                joint.axis[2] * sine},
                 joint.origin, palm_CELLS_PER_UNIT);
}

}  // namespace

ArmPose arm_pose(const float (&angles)[kJointCount]) {
  ArmPose arm = {{kIdentity, kIdentity, kIdentity, kIdentity, kIdentity, kIdentity, kIdentity}};
  for (int i = 0; i < kJointCount; ++i) {
    arm.link[i + 1] = Pose::composed(arm.link[i], rotated(kJoints[i], angles[i]));
  }
  return arm;
}
