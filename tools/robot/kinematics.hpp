// Where the joints and links of a model lie, in doubles.
//
// What rounding adds up to is below 10^-13 of the robot's size a joint: 10^-4 cells at 2^20 cells
// and 64 joints.
#pragma once

#include <array>
#include <vector>

#include "flashbvh/pose.hpp"
#include "flashbvh/robot/robot.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

using Vector3 = std::array<double, 3>;

/// Closed.
struct Interval {
  double lower;
  double upper;
};

/// First `inner`, then `outer`.
Transform composed(const Transform& outer, const Transform& inner);
Transform inverse(const Transform& transform);
Vector3 rotated(const Transform& transform, const Vector3& vector);
/// By the inverse rotation.
Vector3 rotated_back(const Transform& transform, const Vector3& vector);
Vector3 placed(const Transform& transform, const Vector3& point);

/// What the variable can be: the limits of the joint that is no mimic, and 2^-22 of them or of 1
/// more, whichever is larger, so that a limit that was rounded to a float is within them. A mimic's
/// own ones are not looked at, here nor in firmware.
Interval range_of_variable(const Model& model, std::size_t variable);
/// What its coordinate can be.
Interval range_of_joint(const Model& model, std::size_t joint);

/// Of all joints, in the base's frame.
std::vector<Transform> frames_of(const Model& model, const std::vector<double>& variables);

/// The joints of a's branch that are not of b's, from its own inwards; and the other way round.
struct JointsBetween {
  std::vector<std::size_t> of_a;
  std::vector<std::size_t> of_b;
};
JointsBetween joints_between(const Model& model, std::size_t link_a, std::size_t link_b);

/// Of joints from a link inwards, in that order, each joint's frame in that of the last one's
/// parent.
std::vector<Transform> frames_inwards(const Model& model, const std::vector<std::size_t>& joints,
                                      const std::vector<double>& variables);
/// Where link b lies in link a's frame, by joints between them alone.
Transform frame_between(const Model& model, const JointsBetween& joints,
                        const std::vector<double>& variables);

/// On the lattice. UserError if it is further off than poses reach.
Pose pose_of(const Transform& transform, double cell);

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
