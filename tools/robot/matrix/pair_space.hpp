// The joint space of two links: relative poses, motion and exact queries.
#pragma once

#include <functional>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"

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

template <class MeshType>
class BasicPairSpace {
 public:
  using Link = BasicPairLink<MeshType>;
  using Hint = Witness<typename MeshType::Index>;

  /// The model, and the arrays that the meshes view, must outlive the object.
  BasicPairSpace(const Model& model, const Link& a, const Link& b, double cell);

  /// Empty if nothing moves the links.
  const std::vector<Dimension>& dimensions() const { return dimensions_; }
  /// The number of a variable's dimension, or that of all dimensions if it has none.
  std::size_t dimension_of(std::size_t variable) const;
  /// `point`: a value for each dimension. All other variables are in the middle of their ranges.
  std::vector<double> variables_at(const std::vector<double>& point) const;

  /// The motion over all values within `halves` of `point`.
  Motion motion(const std::vector<double>& point, const std::vector<double>& halves) const;

  /// B's frame in A's.
  Transform frame_at(const std::vector<double>& point) const;
  /// True if the links are found to be more than `distance` cells apart.
  bool are_apart(const std::vector<double>& point, double distance) const;
  /// The result of the exact query, with B at pose_of() in A's frame.
  bool intersect(const std::vector<double>& point) const;
  /// Calls `visit` with the ids of each two triangles within `distance` cells, or kMaxGuardDistance
  /// if that is less, until it returns false.
  void find_near(const std::vector<double>& point, double distance,
                 const std::function<bool(std::uint32_t, std::uint32_t)>& visit) const;
  /// A lower bound on the distance in cells: exact if the links are near, 0 if they intersect.
  /// `hint`: the nearest pair of the last call; set to the current one.
  double distance(const std::vector<double>& point, Hint& hint) const;
  /// A vertex's error of placing in addition to kPlacing, in cells: rotations are kept to 2^-23.
  double far_origin() const;

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
  static Bounds bounds_of(const MeshType& mesh, double cell);
  Interval one_turn(std::size_t variable) const;
  std::vector<double> motions(const Bounds& bounds, const Transform& frame,
                              const std::vector<Transform>& joints,
                              const std::vector<double>& halves, bool of_a) const;
  /// The gap between the links' bounding spheres, in cells.
  double least_gap(const Transform& frame) const;

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

// Instantiated in pair_space.cpp.
extern template class BasicPairSpace<WholeMesh>;
extern template class BasicPairSpace<Mesh>;

/// For deciding pairs.
using PairLink = BasicPairLink<WholeMesh>;
using PairSpace = BasicPairSpace<WholeMesh>;
/// For making a guard's distance tables.
using FirmwarePairSpace = BasicPairSpace<Mesh>;

}  // namespace flashbvh::tool
