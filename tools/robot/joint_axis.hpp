// Axes of joints, turned to z, and how far joints turn.
#ifndef FLASHBVH_TOOLS_ROBOT_JOINT_AXIS_HPP
#define FLASHBVH_TOOLS_ROBOT_JOINT_AXIS_HPP

#include "flashbvh/robot/robot.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::tool {

constexpr double kPi = 3.14159265358979323846;
/// Limits of joints that turn are below it, in radians, to either side.
constexpr double kMaxAngle = 2 * kPi * kMaxJointCoordinate / kFullTurn;

/// A rotation that takes z to `axis`, a unit vector: the identity for z, signed permutations for
/// the other five of the frame, so that frames at right angles stay exact.
///
/// The shortest one (Moller and Hughes 1999, Efficiently Building a Matrix to Rotate One Vector to
/// Another); below the equator after half a turn about x, since the shortest to -z is none.
inline Transform rotation_to(Vector3 axis) {
  const double flip = axis[2] < 0 ? -1 : 1;
  const double x = flip * axis[0];
  const double y = flip * axis[1];
  const double z = flip * axis[2];
  const double h = 1 / (1 + z);
  Transform turned;
  turned.rotation = {{{1 - h * x * x, flip * (-h * x * y), flip * x},
                      {-h * x * y, flip * (1 - h * y * y), flip * y},
                      {-x, flip * -y, flip * z}}};
  return turned;
}

}  // namespace flashbvh::tool

#endif
