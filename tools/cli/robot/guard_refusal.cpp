// Explains why a guard refuses the values of a period.
#include <cmath>

#include "cli/robot/guard_output.hpp"
#include "robot/kinematics.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A prismatic joint's value beyond so many times its limits is taken for millimetres.
constexpr double kOtherUnit = 10;

bool slides(const ModelJoint& joint) {
  return joint.type == JointType::prismatic;
}

/// True if the value is so large that it may be in degrees, or in millimetres.
bool has_other_unit(const ModelJoint& joint, double value) {
  const double most = std::fmax(std::fabs(joint.lower), std::fabs(joint.upper));
  return std::fabs(value) > (slides(joint) ? kOtherUnit * most : kTurn);
}

/// "; in degrees? give radians: 1.5708".
std::string other_unit(const ModelJoint& joint, double value) {
  return slides(joint) ? "; in millimetres? give metres: " + significant(value / 1000, 6)
                       : "; in degrees? give radians: " + significant(value * kTurn / 360, 6);
}

/// Six significant digits, or as many more as it takes to satisfy the condition.
template <class Condition>
std::string digits_until(double value, const Condition& is_enough) {
  constexpr int kMostDigits = 17;  // of a double
  int digits = 6;
  while (digits != kMostDigits && !is_enough(*parse_number(significant(value, digits)))) {
    ++digits;
  }
  return significant(value, digits);
}

/// The shortest text that reads back as this float.
std::string float_text(double value) {
  return digits_until(
      value, [&](double read) { return static_cast<float>(read) == static_cast<float>(value); });
}

/// A limit, rounded so little that it stays on its side of the value.
std::string limit_text(double limit, double value) {
  return digits_until(
      limit, [&](double read) { return read != value && (read < value) == (limit < value); });
}

/// "joint 'fold' can't be at 3.5", "joint 'other' can't follow 'grip' to 3.5".
std::string refused_place(const ModelJoint& joint, const ModelJoint& moved, double value) {
  return concat(
      "joint '", joint.name,
      joint.name == moved.name ? "' can't be at " : "' can't follow '" + moved.name + "' to ",
      float_text(value), ": ");
}

/// The error of a value beyond the range of a coordinate.
std::string beyond_range(const GuardedTrajectory& guarded, const ModelJoint& moved, double value) {
  if (!slides(moved)) {
    return "firmware takes less than 8 turns, 50.27 radians; leave full turns out" +
           other_unit(moved, value);
  }
  const double most = kMaxJointCoordinate * cell_of(guarded.robot()) / kFrameCell;
  return concat("firmware takes less than ", significant(most, 4), " m of this robot",
                other_unit(moved, value));
}

/// The error of a value beyond its limits. `moved`: the value's joint, which `joint` may follow.
std::string beyond_limits(const ModelJoint& joint, const ModelJoint& moved, double value) {
  const double own = joint.multiplier * value + joint.offset;
  return concat(
      "its limits are ", limit_text(joint.lower, own), " and ", limit_text(joint.upper, own),
      has_other_unit(moved, value) ? (slides(moved) ? " m" : " radians") + other_unit(moved, value)
                                   : "; correct the value, or the URDF");
}

}  // namespace

std::string why_refused(const GuardedTrajectory& guarded, std::size_t period) {
  const Status status = guarded.answers[period].status;
  if (status == Status::joint_jumped) {
    return "a joint without limits turns by half a turn, which may be either way; give values in "
           "between";
  }
  if (status != Status::joint_out_of_limits && status != Status::not_a_coordinate) {
    return concat("the guard can't go on: ", status_name(status));
  }
  const Trajectory& read = guarded.limits.empty() ? guarded.trajectory : guarded.wanted;
  const float* const values = read.values(period);
  const Model& model = guarded.model;
  const ModelJoint& joint = model.joints[refused_joint(guarded.robot(), values)];
  const ModelJoint& moved = model.joints[model.variables[joint.variable]];
  const auto value = static_cast<double>(values[joint.variable]);
  return refused_place(joint, moved, value) + (status == Status::not_a_coordinate
                                                   ? beyond_range(guarded, moved, value)
                                                   : beyond_limits(joint, moved, value));
}

}  // namespace flashbvh::tool
