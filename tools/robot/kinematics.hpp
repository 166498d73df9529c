// Frames of a model's joints and links, in doubles.
//
// Accumulated rounding is below 10^-13 of the robot's size per joint: 10^-4 cells at 2^20 cells and
// 64 joints.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "flashbvh/pose.hpp"
#include "flashbvh/robot/robot.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

using Vector3 = std::array<double, 3>;

/// A closed interval.
struct Interval {
  double lower;
  double upper;
};

/// A rotation by a unit quaternion (w, x, y, z), then a translation.
Transform transform_of_quaternion(const std::array<double, 4>& quaternion,
                                  const Vector3& translation);
/// Applies `inner`, then `outer`.
Transform composed(const Transform& outer, const Transform& inner);
Transform inverse(const Transform& transform);
Vector3 rotated(const Transform& transform, const Vector3& vector);
/// Applies the inverse rotation.
Vector3 rotated_back(const Transform& transform, const Vector3& vector);
Vector3 placed(const Transform& transform, const Vector3& point);
double length_of(const Vector3& vector);

/// A variable's range: the limits of the joint that is no mimic, widened by 2^-22 of the limit or
/// of 1, whichever is larger. So a limit rounded to a float is inside. A mimic's own limits are
/// ignored, here and in firmware.
Interval range_of_variable(const Model& model, std::size_t variable);
/// The range of a joint's coordinate.
Interval range_of_joint(const Model& model, std::size_t joint);

/// The frames of all joints, in the base's frame.
std::vector<Transform> frames_of(const Model& model, const std::vector<double>& variables);

/// The joints on only one of the branches of a and b, each from the link towards the base.
struct JointsBetween {
  std::vector<std::size_t> of_a;
  std::vector<std::size_t> of_b;
};
JointsBetween joints_between(const Model& model, std::size_t link_a, std::size_t link_b);

/// The joint between two neighbours, if it is the only one.
std::optional<std::size_t> joint_of_neighbours(const Model& model, std::size_t a, std::size_t b);
/// True if the joint is the only one between two neighbours with meshes.
bool is_between_neighbours(const Model& model, std::size_t joint);

/// The frames of `joints`, which run from a link towards the base: each in the frame of the last
/// joint's parent.
std::vector<Transform> frames_inwards(const Model& model, const std::vector<std::size_t>& joints,
                                      const std::vector<double>& variables);
/// Link b's frame in link a's frame, computed from the joints between them alone.
Transform frame_between(const Model& model, const JointsBetween& joints,
                        const std::vector<double>& variables);

/// The frame in fixed point, rounded to the nearest, and back. `cell`: of the frame's lengths.
Frame fixed_frame(const Transform& transform, double cell);
Transform transform_of(const Frame& frame, double cell);

/// The pose on the lattice. UserError if it exceeds the range of poses.
Pose pose_of(const Transform& transform, double cell);

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurn = 2 * kPi;  ///< a full turn, in radians
/// Limits of rotating joints are smaller than this in magnitude, in radians.
constexpr double kMaxAngle = kTurn * kMaxJointCoordinate / kFullTurn;

/// A rotation that takes z to `axis`, a unit vector. Frames at right angles stay exact: it is the
/// identity for z, and a signed permutation for the other five axis directions.
///
/// The shortest rotation (Moller and Hughes 1999, Efficiently Building a Matrix to Rotate One
/// Vector to Another). If z of `axis` is negative, half a turn about x comes first: no rotation to
/// -z is the shortest.
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
