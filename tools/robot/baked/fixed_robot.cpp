#include "robot/baked/fixed_robot.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// A bounding sphere of meshes, in cells.
struct BoundingSphere {
  std::array<double, 3> centre;
  double radius;
};

using Point = std::array<double, 3>;

template <class MeshType>
std::vector<Point> vertices_of(const MeshType& mesh) {
  std::vector<Point> points;
  points.reserve(mesh.vertex_count);
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const Vertex& vertex = mesh.vertices[i];
    points.push_back({static_cast<double>(mesh.origin[0]) + vertex.x,
                      static_cast<double>(mesh.origin[1]) + vertex.y,
                      static_cast<double>(mesh.origin[2]) + vertex.z});
  }
  return points;
}

/// All vertices of the whole mesh, and those that only firmware's mesh has.
std::vector<Point> vertices_of(const WholeMesh& whole, const Mesh* baked) {
  std::vector<Point> points = vertices_of(whole);
  if (baked != nullptr) {
    std::vector<Point> known = points;
    std::sort(known.begin(), known.end());
    for (const Point& point : vertices_of(*baked)) {
      if (!std::binary_search(known.begin(), known.end(), point)) {
        points.push_back(point);
      }
    }
  }
  return points;
}

double distance(const Point& p, const Point& q) {
  return bake::length(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Within 1 % of the smallest (Badoiu and Clarkson, "Smaller core-sets for balls", 2003).
BoundingSphere bounding_sphere(const std::vector<Point>& points) {
  constexpr int steps = 200;
  Point centre = points[0];
  for (int step = 1; step <= steps; ++step) {
    Point farthest = centre;
    for (const Point& point : points) {
      farthest = distance(centre, point) > distance(centre, farthest) ? point : farthest;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centre[axis] += (farthest[axis] - centre[axis]) / (step + 1);
    }
  }
  double radius = 0;
  for (const Point& point : points) {
    radius = std::fmax(radius, distance(centre, point));
  }
  return {centre, radius};
}

double unit_of(const ModelJoint& joint, double cell) {
  return unit_of_coordinate(joint.type, cell);
}

std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(std::lround(value));
}

Frame frame_of(const Transform& transform, double cell) {
  Frame frame{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      frame.rotation[i][j] = rounded(transform.rotation[i][j] * kRotationOne);
    }
    frame.translation[i] = rounded(transform.translation[i] / cell * kFrameCell);
  }
  return frame;
}

/// Firmware's number of a joint.
std::uint8_t number_of(std::size_t joint) {
  return joint == kNoJoint ? kBase : static_cast<std::uint8_t>(joint);
}

/// Limits in units of the coordinate: integers, which may exclude all values.
Interval fixed_limits(const Model& model, std::size_t joint, double cell) {
  const Interval range = range_of_joint(model, joint);
  const double unit = unit_of(model.joints[joint], cell);
  const double rounding = is_mimic(model, joint) ? 3 : 0;
  return {std::ceil(range.lower / unit) - rounding, std::floor(range.upper / unit) + rounding};
}

/// Sets how a mimic's coordinate follows from its variable.
void set_mimic(const Model& model, const ModelJoint& joint, double cell, RobotJoint& fixed) {
  const ModelJoint& master = model.joints[model.variables[joint.variable]];
  const double unit = unit_of(joint, cell);
  const double factor = joint.multiplier * unit_of(master, cell) / unit;
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

Mount fixed_mount(const ModelMount& mount, double cell) {
  return {number_of(mount.joint), frame_of(mount.transform, cell)};
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
  check_size(model);
  check_deviations(model);
  for (const GuardedPair& pair : pairs) {
    add_pair(model, pair);
  }
  check_reach();
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
  robot_.slack = slack(model);
  check_slack(model);
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
  fixed.fixed = frame_of(joint.fixed, cell_);
  fixed.parent = number_of(joint.parent);
  fixed.variable = static_cast<std::uint8_t>(joint.variable);
  fixed.type = joint.type;
  fixed.multiplier = 1;
  if (is_mimic(model, number)) {
    set_mimic(model, joint, cell_, fixed);
  }
  if (joint.type != JointType::continuous) {
    const double unit = unit_of(joint, cell_);
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
  const Mesh* const baked = meshes_.empty() ? nullptr : &meshes_[number];
  RobotLink fixed{};
  const BoundingSphere sphere = bounding_sphere(vertices_of(whole, baked));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fixed.centre[axis] = rounded(sphere.centre[axis] * kFrameCell);
  }
  fixed.radius = static_cast<std::uint32_t>(std::ceil(sphere.radius * kFrameCell)) + 2;
  fixed.first_reach = static_cast<std::uint16_t>(reaches_.size());
  fixed.joint = number_of(link.joint);
  deviations_.push_back(deviation / cell_);
  fixed.deviation = static_cast<std::uint32_t>(std::min(
      bake::parts_above(static_cast<double>(bake::float_above(deviation)), cell_, kFineOne),
      double{UINT32_MAX}));
  for (std::size_t j = link.joint; j != kNoJoint; j = model.joints[j].parent) {
    const double unit = unit_of(model.joints[j], cell_);
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
  pair_joint_count_ += fixed.joints_a + fixed.joints_b;
  pairs_.push_back(fixed);
}

/// The sum over all joints between the links.
double FixedRobot::reach_of(const RobotPair& pair) const {
  double sum = 0;
  for (std::size_t i = 0; i < pair.joints_a; ++i) {
    sum += wide_reaches_[links_[pair.a].first_reach + i];
  }
  for (std::size_t i = 0; i < pair.joints_b; ++i) {
    sum += wide_reaches_[links_[pair.b].first_reach + i];
  }
  return sum;
}

/// UserError if a pair's reach is too large for the guard's sums.
void FixedRobot::check_reach() const {
  if (most_reach_ > UINT32_MAX) {
    throw UserError("robot", "its joints move links too far for so fine a lattice: give --cell ",
                    significant(cell_ * most_reach_ / UINT32_MAX * 1.01, 3), " or more");
  }
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

void FixedRobot::check_size(const Model& model) const {
  constexpr double most = static_cast<double>(kMaxFrameTranslation - (1 << 16)) / kFrameCell;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const double extent = extent_of(model, i);
    if (extent > most) {
      throw UserError(at_element(model.path, "link", model.links[i].name), "lies up to ",
                      significant(extent * cell_, 4), " m from the base, ", significant(extent, 6),
                      " cells; at most ", significant(most, 6), ": give --cell ",
                      significant(cell_ * extent / most * 1.01, 3), " or more");
    }
  }
}

/// UserError if a guard would stop links too early for firmware by their deviations alone.
void FixedRobot::check_deviations(const Model& model) const {
  constexpr double most = kMaxGuardDistance / (2.0 * kFineOne);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (deviations_[i] > most) {
      throw UserError(at_element(model.path, "link", model.links[i].name),
                      "is simplified by up to ", significant(deviations_[i] * cell_, 3),
                      " m; a guard holds less than ", significant(most * cell_, 3),
                      " m: give a smaller --simplify, or --fit more");
    }
  }
}

/// UserError if errors of kinematics and deviations add up to more than firmware holds.
void FixedRobot::check_slack(const Model& model) const {
  if (robot_.slack > kMaxGuardDistance) {
    throw UserError(model.path, "a guard would stop its links ",
                    significant(robot_.slack * cell_ / kFineOne, 3),
                    " m too early, more than firmware holds, ",
                    significant(kMaxGuardDistance * cell_ / kFineOne, 3),
                    " m; give a larger --cell or a smaller --simplify");
  }
}

/// The errors of placing and of both links' rounding and kinematics (lib/docs/derivations.md,
/// "Robots").
std::uint32_t FixedRobot::slack(const Model& model) const {
  double most = 0;
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
    double error = deviations_[i];
    std::size_t reach = links_[i].first_reach;
    for (std::size_t j = model.links[i].joint; j != kNoJoint; j = model.joints[j].parent) {
      // Errors of its rotation's norm, its translation, rounded twice, and its coordinate.
      const double coordinate = is_mimic(model, j) ? 3 : 1;
      error += extent * 0x1p-27 + 2 * 1.7321 / 2 / kFrameCell +
               coordinate * std::ldexp(reaches_[reach++], -kReachBits) / 256;
    }
    most = std::max(most, error + extent * 0x1p-29 + 1.0 / kFrameCell);
  }
  return static_cast<std::uint32_t>(std::ceil((placing_at(far) + 2 * most) * 256));
}

}  // namespace flashbvh::tool
