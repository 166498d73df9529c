#include "robot/baked/fixed_robot.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "bake/length.hpp"
#include "bake/quantise.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/image.hpp"
#include "image/fine_length.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/read/xml_file.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A bounding sphere, in cells.
struct BoundingSphere {
  Vector3 centre;
  double radius;
};

double distance(const Vector3& p, const Vector3& q) {
  return bake::length(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Within 1 % of the smallest (Badoiu and Clarkson, "Smaller core-sets for balls", 2003).
BoundingSphere bounding_sphere(const std::vector<Vector3>& points) {
  constexpr int steps = 200;
  Vector3 centre = points[0];
  for (int step = 1; step <= steps; ++step) {
    Vector3 farthest = centre;
    for (const Vector3& point : points) {
      farthest = distance(centre, point) > distance(centre, farthest) ? point : farthest;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] += (farthest[axis] - centre[axis]) / (step + 1);
    }
  }
  double radius = 0;
  for (const Vector3& point : points) {
    radius = std::fmax(radius, distance(centre, point));
  }
  return {centre, radius};
}

std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(std::lround(value));
}

/// Limits in units of the coordinate: integers, which may exclude all values.
Interval fixed_limits(const Model& model, std::size_t joint, double cell) {
  const Interval range = range_of_joint(model, joint);
  const double unit = unit_of_coordinate(model.joints[joint].type, cell);
  const double rounding = is_mimic(model, joint) ? 3 : 0;
  return {std::ceil(range.lower / unit) - rounding, std::floor(range.upper / unit) + rounding};
}

/// Sets how a mimic's coordinate follows from its variable.
void set_mimic(const Model& model, const ModelJoint& joint, double cell, RobotJoint& fixed) {
  const ModelJoint& master = model.joints[model.variables[joint.variable]];
  const double unit = unit_of_coordinate(joint.type, cell);
  const double factor = joint.multiplier * unit_of_coordinate(master.type, cell) / unit;
  const double offset = joint.offset / unit;
  if (!(std::abs(factor) < 0x1p29 && std::abs(offset) < kMaxJointCoordinate)) {
    throw UserError(at_element(model.path, "joint", joint.name),
                    "the multiplier or the offset of its mimic tag is too large");
  }
  int exponent = 0;
  std::frexp(factor, &exponent);
  fixed.shift = static_cast<std::uint8_t>(std::clamp(30 - exponent, 1, 40));
  fixed.multiplier = rounded(std::ldexp(factor, fixed.shift));
  fixed.offset = rounded(offset);
}

}  // namespace

double unit_of_coordinate(JointType type, double cell) {
  return type == JointType::prismatic ? cell / kFrameCell : kTurn / kFullTurn;
}

void check_limits(const Model& model, double cell) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Interval limits = fixed_limits(model, i, cell);
    if (model.joints[i].type != JointType::continuous && limits.lower > limits.upper) {
      throw UserError(at_element(model.path, "joint", model.joints[i].name),
                      "has limits so narrow that no value keeps them; make it fixed");
    }
  }
}

FixedRobot::FixedRobot(const Model& model, const std::vector<WholeMesh>& wholes,
                       const std::vector<Mesh>& meshes, double cell,
                       const std::vector<GuardedPair>& pairs, const Reaches& reaches,
                       const std::vector<double>& deviations)
    : cell_(cell), meshes_(meshes) {
  check_counts(model, model.path);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    add_joint(model, i);
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    add_link(model, i, wholes[i], i < reaches.size() ? reaches[i] : reaches_of(model, i, cell),
             deviations.empty() ? link_deviation(model.links[i], cell) : deviations[i]);
  }
  for (const GuardedPair& pair : pairs) {
    add_pair(model, pair);
  }
  if (most_reach_ > UINT32_MAX) {  // too large for the guard's sums
    throw UserError("robot", "its joints move links too far for so fine a lattice: give --cell ",
                    significant(cell_ * most_reach_ / UINT32_MAX * 1.01, 3), " or more");
  }
  robot_.joints = joints_.data();
  robot_.links = links_.data();
  robot_.meshes = meshes_.data();
  robot_.pairs = pairs_.data();
  robot_.reaches = reaches_.data();
  robot_.joint_count = static_cast<std::uint8_t>(joints_.size());
  robot_.link_count = static_cast<std::uint8_t>(links_.size());
  robot_.variable_count = static_cast<std::uint8_t>(model.variables.size());
  robot_.pair_count = static_cast<std::uint16_t>(pairs_.size());
  robot_.reach_count = static_cast<std::uint16_t>(reaches_.size());
  robot_.slack = checked_slack(model);
  std::memcpy(&robot_.cell_bits, &cell_, sizeof cell_);
  robot_.hash = meshes_.empty() ? 1 : robot_hash(robot_);
}

void FixedRobot::set_distance_tables(std::vector<std::uint8_t> distance_tables) {
  distance_tables_ = std::move(distance_tables);
  robot_.distance_tables = distance_tables_.data();
  robot_.distance_table_bytes = static_cast<std::uint32_t>(distance_tables_.size());
  robot_.hash = robot_hash(robot_);
}

void FixedRobot::add_joint(const Model& model, std::size_t number) {
  const ModelJoint& joint = model.joints[number];
  RobotJoint fixed{};
  fixed.fixed = fixed_frame(joint.fixed, cell_);
  fixed.parent = fixed_joint(joint.parent);
  fixed.variable = static_cast<std::uint8_t>(joint.variable);
  fixed.type = joint.type;
  fixed.multiplier = 1;
  if (is_mimic(model, number)) {
    set_mimic(model, joint, cell_, fixed);
  }
  if (joint.type != JointType::continuous) {
    const double unit = unit_of_coordinate(joint.type, cell_);
    const auto [lower, upper] = fixed_limits(model, number, cell_);
    if (lower < -kMaxJointCoordinate || upper > kMaxJointCoordinate) {
      throw UserError(at_element(model.path, "joint", joint.name),
                      "its limits are too far: at most ",
                      significant(kMaxJointCoordinate * unit, 6), " either way");
    }
    fixed.lower = static_cast<JointCoordinate>(lower);
    fixed.upper = static_cast<JointCoordinate>(upper);
  }
  joints_.push_back(fixed);
}

void FixedRobot::add_link(const Model& model, std::size_t number, const WholeMesh& whole,
                          const std::vector<double>& reaches, double deviation) {
  const ModelLink& link = model.links[number];
  RobotLink fixed{};
  std::vector<Vector3> points = vertices_of(whole);
  if (!meshes_.empty()) {
    const std::vector<Vector3> more = vertices_of(meshes_[number]);
    points.insert(points.end(), more.begin(), more.end());
  }
  const BoundingSphere sphere = bounding_sphere(points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fixed.centre[axis] = rounded(sphere.centre[axis] * kFrameCell);
  }
  fixed.radius = static_cast<std::uint32_t>(std::ceil(sphere.radius * kFrameCell)) + 2;
  fixed.first_reach = static_cast<std::uint16_t>(reaches_.size());
  fixed.joint = fixed_joint(link.joint);
  fixed.deviation = static_cast<std::uint32_t>(std::min(
      bake::parts_above(static_cast<double>(bake::float_above(deviation)), cell_, kFineOne),
      double{UINT32_MAX}));
  for (std::size_t j = link.joint; j != kNoJoint; j = model.joints[j].parent) {
    const double unit = unit_of_coordinate(model.joints[j].type, cell_);
    const double fine = reaches[j] * unit / cell_ * 256;
    wide_reaches_.push_back(std::ceil(std::ldexp(fine, kReachBits)));
    reaches_.push_back(
        static_cast<std::uint32_t>(std::min(wide_reaches_.back(), double{UINT32_MAX})));
  }
  links_.push_back(fixed);
}

void FixedRobot::add_pair(const Model& model, const GuardedPair& pair) {
  const JointsBetween between = joints_between(model, pair.a, pair.b);
  RobotPair fixed{};
  fixed.a = static_cast<std::uint8_t>(pair.a);
  fixed.b = static_cast<std::uint8_t>(pair.b);
  fixed.joints_a = static_cast<std::uint8_t>(between.of_a.size());
  fixed.joints_b = static_cast<std::uint8_t>(between.of_b.size());
  fixed.stop = fine_length_rounded_up(pair.stop, cell_).count;
  fixed.warn = fine_length_rounded_up(pair.warn, cell_).count;
  const double reach = reach_of(fixed);
  most_reach_ = std::max(most_reach_, reach);
  fixed.reach = static_cast<std::uint32_t>(std::min(reach, double{UINT32_MAX}));
  pairs_.push_back(fixed);
}

/// The sum over all joints between the links.
double FixedRobot::reach_of(const RobotPair& pair) const {
  const auto sum = [&](std::uint8_t link, std::uint8_t joints) {
    const auto first = wide_reaches_.begin() + links_[link].first_reach;
    return std::accumulate(first, first + joints, 0.0);
  };
  return sum(pair.a, pair.joints_a) + sum(pair.b, pair.joints_b);
}

/// A bound on the distance of the link's points from the base's origin, in cells.
double FixedRobot::extent_of(const Model& model, std::size_t number) const {
  const RobotLink& link = links_[number];
  double extent = link.radius + bake::length(link.centre[0], link.centre[1], link.centre[2]);
  for (std::size_t j = model.links[number].joint; j != kNoJoint; j = model.joints[j].parent) {
    const RobotJoint& joint = joints_[j];
    extent += length_of(model.joints[j].fixed.translation) / cell_ * kFrameCell;
    extent += joint.type == JointType::prismatic
                  ? std::max(std::abs(joint.lower), std::abs(joint.upper))
                  : 0;
  }
  return extent / kFrameCell;
}

/// The errors of placing and, of the two worst links, of rounding and of kinematics
/// (lib/docs/derivations.md, "Robots"). UserError if firmware cannot hold them.
std::uint32_t FixedRobot::checked_slack(const Model& model) const {
  double most = 0;
  double deviation = 0;
  double far = 0;
  for (const Mesh& mesh : meshes_) {
    double sum = 0;
    for (const std::int32_t coordinate : mesh.origin) {
      sum += std::abs(static_cast<double>(coordinate));
    }
    far = std::max(far, sum);
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const double extent = extent_of(model, i);
    double error = 0;
    std::size_t reach = links_[i].first_reach;
    for (std::size_t j = model.links[i].joint; j != kNoJoint; j = model.joints[j].parent) {
      // Errors of its rotation's norm, its translation, rounded twice, and its coordinate.
      const double coordinate = is_mimic(model, j) ? 3 : 1;
      error += extent * 0x1p-27 + 2 * 1.7321 / 2 / kFrameCell +
               coordinate * std::ldexp(reaches_[reach++], -kReachBits) / 256;
    }
    most = std::max(most, error + extent * 0x1p-29 + 1.0 / kFrameCell);
    deviation = std::max(deviation, links_[i].deviation / double{kFineOne});
  }
  const double slack = std::ceil((placing_at(far) + 2 * (deviation + most)) * kFineOne);
  if (slack > kMaxGuardDistance) {
    throw UserError(model.path, "a guard would stop its links ",
                    significant(slack * cell_ / kFineOne, 3),
                    " m too early, more than firmware holds, ",
                    significant(kMaxGuardDistance * cell_ / kFineOne, 3),
                    " m; give a larger --cell, a smaller --simplify, or --fit more");
  }
  return static_cast<std::uint32_t>(slack);
}

}  // namespace flashbvh::tool
