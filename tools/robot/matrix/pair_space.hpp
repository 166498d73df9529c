// The joint space of two links: relative poses, motion and exact queries.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"
#include "simplify/nearest.hpp"

namespace flashbvh::tool {

/// A link of a pair.
template <class MeshType>
struct BasicPairLink {
  std::size_t link;
  MeshType mesh;
  const std::vector<double>* reaches = nullptr;  ///< of reaches_of(), or null: of the mesh's box
};

/// A variable that moves the links relative to each other.
struct Dimension {
  std::size_t variable;
  /// At most one turn if the variable only rotates joints, each with a multiplier of 1 or -1.
  Interval range;
};

/// A bound on the motion of both links' points from the middle of a joint box, in cells, as seen
/// from some body between the links.
struct Motion {
  std::vector<double> parts;  ///< by each dimension
  double sum = 0;
};

/// The distance of a point from an axis, the z of a frame.
inline double distance_from(const Transform& axis, const Vector3& point) {
  double along = 0;
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = point[i] - axis.translation[i];
    along += d * axis.rotation[i][2];
    squared += d * d;
  }
  return std::sqrt(std::max(0.0, squared - along * along));
}

template <class MeshType>
class BasicPairSpace {
 public:
  using Link = BasicPairLink<MeshType>;
  using Hint = Witness<typename MeshType::Index>;

  /// The model, and the arrays that the meshes view, must outlive the object.
  BasicPairSpace(const Model& model, const Link& a, const Link& b, double cell)
      : model_(model),
        a_(a.mesh),
        b_(b.mesh),
        cell_(cell),
        joints_(joints_between(model, a.link, b.link)),
        bounds_a_(bounds_of(a_, cell)),
        bounds_b_(bounds_of(b_, cell)) {
    std::vector<std::size_t> path = joints_.of_a;
    path.insert(path.end(), joints_.of_b.rbegin(), joints_.of_b.rend());
    for (const std::size_t joint : path) {
      const std::size_t variable = model.joints[joint].variable;
      const std::size_t dimension = dimension_of(variable);
      if (dimension == dimensions_.size()) {
        dimensions_.push_back({variable, one_turn(variable)});
      }
      const auto reach_of = [&](const Link& link) {
        const bool slides = model.joints[joint].type == JointType::prismatic;
        return link.reaches != nullptr ? (*link.reaches)[joint] : slides ? 1 : HUGE_VAL;
      };
      path_.push_back({joint, dimension, reach_of(a), reach_of(b)});
    }
    for (std::size_t i = 0; i < model.variables.size(); ++i) {
      const Interval range = range_of_variable(model, i);
      middle_.push_back(range.lower + (range.upper - range.lower) / 2);
    }
  }

  /// Empty if nothing moves the links.
  const std::vector<Dimension>& dimensions() const { return dimensions_; }
  /// The number of a variable's dimension, or that of all dimensions if it has none.
  std::size_t dimension_of(std::size_t variable) const {
    const auto found = std::find_if(dimensions_.begin(), dimensions_.end(),
                                    [&](const Dimension& of) { return of.variable == variable; });
    return static_cast<std::size_t>(found - dimensions_.begin());
  }
  /// `point`: a value for each dimension. All other variables are in the middle of their ranges.
  std::vector<double> variables_at(const std::vector<double>& point) const {
    std::vector<double> variables = middle_;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      variables[dimensions_[i].variable] = point[i];
    }
    return variables;
  }

  /// The motion over all values within `halves` of `point`: the smallest as seen from a body
  /// between the links. Joints on a's side of it move a, and the others move b.
  Motion motion(const std::vector<double>& point, const std::vector<double>& halves) const {
    const std::vector<double> variables = variables_at(point);
    std::vector<Transform> joints = frames_inwards(model_, joints_.of_a, variables);
    const std::vector<Transform> others = frames_inwards(model_, joints_.of_b, variables);
    const Transform frame_a = joints.empty() ? Transform() : joints.front();
    const Transform frame_b = others.empty() ? Transform() : others.front();
    joints.insert(joints.end(), others.rbegin(), others.rend());
    const std::vector<double> by_a = motions(bounds_a_, frame_a, joints, halves, true);
    const std::vector<double> by_b = motions(bounds_b_, frame_b, joints, halves, false);
    double sum = 0;
    for (const double by : by_b) {
      sum += by;
    }
    double least = sum;
    std::size_t cut = 0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      sum += by_a[i] - by_b[i];
      if (sum < least) {
        least = sum;
        cut = i + 1;
      }
    }
    Motion motion;
    motion.parts.resize(dimensions_.size());
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const double by = (i < cut ? by_a : by_b)[i] / cell_;
      motion.parts[path_[i].dimension] += by;
      motion.sum += by;
    }
    return motion;
  }

  /// B's frame in A's.
  Transform frame_at(const std::vector<double>& point) const {
    return frame_between(model_, joints_, variables_at(point));
  }
  /// True if the links are found to be more than `distance` cells apart.
  bool are_apart(const std::vector<double>& point, double distance) const {
    const Transform frame = frame_at(point);
    if (least_gap(frame) > distance) {
      return true;
    }
    const double steps = std::ceil(distance * 256);
    if (steps > kMaxGuardDistance) {
      return false;
    }
    return !closer_than(a_, b_, pose_of(frame, cell_), {static_cast<std::uint32_t>(steps)}).yes;
  }
  /// The result of the exact query, with B at pose_of() in A's frame.
  bool intersect(const std::vector<double>& point) const {
    const Transform frame = frame_at(point);
    return least_gap(frame) <= 0 && intersects(a_, b_, pose_of(frame, cell_)).yes;
  }
  /// Calls `visit` with the ids of each two triangles within `distance` cells, or kMaxGuardDistance
  /// if that is less, until it returns false.
  void find_near(const std::vector<double>& point, double distance,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& visit) const {
    const Pose pose = pose_of(frame_at(point), cell_);
    const double steps = std::min(std::ceil(distance * 256), 1.0 * kMaxGuardDistance);
    Query<Ranked<MeshType>, Within> query(a_, b_, pose, {},
                                          within({static_cast<std::uint32_t>(steps)}));
    (void)query.run(UINT32_MAX, [&](const TrianglePair<typename MeshType::Index>& pair) {
      return visit(pair.a, pair.b);
    });
  }
  /// A lower bound on the distance in cells: exact if the links are near, 0 if they intersect.
  /// `hint`: the nearest pair of the last call; set to the current one.
  double distance(const std::vector<double>& point, Hint& hint) const {
    const Transform frame = frame_at(point);
    const double gap = least_gap(frame);
    if (gap > kMaxGuardDistance / 256.0) {
      return gap;
    }
    const auto found = flashbvh::distance(a_, b_, pose_of(frame, cell_), hint);
    if (found.in_range) {
      hint = found.witness;
    }
    return found.lower / 256.0;
  }
  /// A vertex's error of placing in addition to kPlacing, in cells: rotations are kept to 2^-23.
  double far_origin() const {
    const auto of = [](const MeshType& mesh) {
      double sum = 0;
      for (const std::int32_t coordinate : mesh.origin) {
        sum += std::fabs(coordinate);
      }
      return std::sqrt(3.0) * sum / (1 << 23);
    };
    return std::max(of(a_), of(b_));
  }

 private:
  /// The bounding box and sphere of a mesh, in its frame, in metres.
  struct Bounds {
    std::array<Vector3, 8> corners;
    Vector3 centre;
    double radius;
  };
  /// A joint on the path from a to b.
  struct PathJoint {
    std::size_t joint;
    std::size_t dimension;
    double reach_a;  ///< metres
    double reach_b;
  };
  static Bounds bounds_of(const MeshType& mesh, double cell) {
    simplify::Box box;
    for (const auto& [x, y, z] : vertices_of(mesh)) {
      box.add({cell * x, cell * y, cell * z});
    }
    const auto& [low, high] = box;
    Bounds bounds{};
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        bounds.corners[i][k] = ((i >> k) & 1) != 0 ? high[k] : low[k];
      }
    }
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.centre[k] = (low[k] + high[k]) / 2;
      squared += (high[k] - low[k]) * (high[k] - low[k]) / 4;
    }
    bounds.radius = std::sqrt(squared) + cell;
    return bounds;
  }
  /// A variable's range, or one turn about the range's middle if all joints of the variable rotate
  /// by its value: one turn contains all relative poses.
  Interval one_turn(std::size_t variable) const {
    const Interval range = range_of_variable(model_, variable);
    const double middle = range.lower + (range.upper - range.lower) / 2;
    for (const ModelJoint& joint : model_.joints) {
      if (joint.variable == variable &&
          (joint.type == JointType::prismatic || std::fabs(joint.multiplier) != 1)) {
        return range;
      }
    }
    return {std::max(range.lower, middle - kPi), std::min(range.upper, middle + kPi)};
  }
  /// Bounds on the motion of a link's points by each joint of the path, in metres. Assume that the
  /// joints move in turn, the furthest from the link first. Each then finds the link at its
  /// distance in the middle of the joint box, because joints nearer to the link have not moved yet.
  std::vector<double> motions(const Bounds& bounds, const Transform& frame,
                              const std::vector<Transform>& joints,
                              const std::vector<double>& halves, bool of_a) const {
    std::array<Vector3, 8> corners{};
    std::transform(bounds.corners.begin(), bounds.corners.end(), corners.begin(),
                   [&](const Vector3& corner) { return placed(frame, corner); });
    std::vector<double> moved;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const ModelJoint& joint = model_.joints[path_[i].joint];
      double reach = of_a ? path_[i].reach_a : path_[i].reach_b;
      if (joint.type != JointType::prismatic) {
        double near = 0;
        for (const Vector3& corner : corners) {
          near = std::max(near, distance_from(joints[i], corner));
        }
        reach = std::min(reach, near + cell_ / 256);
      }
      moved.push_back(reach * std::fabs(joint.multiplier) * halves[path_[i].dimension]);
    }
    return moved;
  }
  /// The gap between the links' bounding spheres, in cells.
  double least_gap(const Transform& frame) const {
    const Vector3 centre = placed(frame, bounds_b_.centre);
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      squared += (centre[k] - bounds_a_.centre[k]) * (centre[k] - bounds_a_.centre[k]);
    }
    return (std::sqrt(squared) - bounds_a_.radius - bounds_b_.radius) / cell_;
  }

  const Model& model_;
  MeshType a_;
  MeshType b_;
  double cell_;
  JointsBetween joints_;
  Bounds bounds_a_;
  Bounds bounds_b_;
  std::vector<PathJoint> path_;
  std::vector<Dimension> dimensions_;
  std::vector<double> middle_;
};

/// For deciding pairs.
using PairLink = BasicPairLink<WholeMesh>;
using PairSpace = BasicPairSpace<WholeMesh>;
/// For making a guard's distance tables.
using FirmwarePairSpace = BasicPairSpace<Mesh>;

}  // namespace flashbvh::tool
