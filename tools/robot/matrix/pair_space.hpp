// Two links and the variables between them: where they lie, how far they can move, what they do.
#pragma once

#include <functional>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/baked_part.hpp"

namespace flashbvh::tool {

/// A link as a pair sees it.
template <class MeshType>
struct BasicPairLink {
  std::size_t link;
  const MeshType* mesh;
  const std::vector<double>* reaches;  ///< reaches_of(), or null: by the mesh's box
};

/// A variable that moves the links against each other.
struct Dimension {
  std::size_t variable;
  Interval range;  ///< at most one turn of variables that only turn joints
};

/// How far a cell of values moves the links' points from where its middle puts them, in cells: seen
/// from some body between the links, those of both together.
struct Motion {
  std::vector<double> parts;  ///< by each dimension
  double sum = 0;
};

template <class MeshType>
class BasicPairSpace {
 public:
  using Link = BasicPairLink<MeshType>;
  using Hint = Witness<typename MeshType::Index>;

  /// Lasts as long as the model and the meshes.
  BasicPairSpace(const Model& model, const Link& a, const Link& b, double cell);

  /// None: nothing moves them.
  const std::vector<Dimension>& dimensions() const { return dimensions_; }
  /// Of a point, a value for each dimension; all others in the middle of their ranges.
  std::vector<double> variables_at(const std::vector<double>& point) const;

  /// What values up to `halves` from `point` do.
  Motion motion(const std::vector<double>& point, const std::vector<double>& halves) const;

  /// Whether the links are detected to be more than `distance` cells apart.
  bool are_apart(const std::vector<double>& point, double distance) const;
  /// By the exact query, of B at pose_of() in A's frame.
  bool intersect(const std::vector<double>& point) const;
  /// Hands each two triangles that are within `distance` cells to `visit`, by their ids: of
  /// at most kMaxGuardDistance.
  void find_near(const std::vector<double>& point, double distance,
                 const std::function<void(std::uint32_t, std::uint32_t)>& visit) const;
  /// In cells, at most the true one; exact where they are near, and 0 if they intersect. `hint`:
  /// what was nearest before, and is now.
  double distance(const std::vector<double>& point, Hint& hint) const;
  /// How far placing moves a vertex in addition to kPlacing, in cells: rotations are kept to 2^-23.
  double far_origin() const;

 private:
  /// What holds a mesh, in its frame, in metres.
  struct Bounds {
    std::array<Vector3, 8> corners;
    Vector3 centre;
    double radius;
  };
  /// A joint on the way from a to b.
  struct PathJoint {
    std::size_t joint;
    std::size_t dimension;
    double reach_a;  ///< metres
    double reach_b;
  };
  static Bounds bounds_of(const MeshType& mesh, double cell);
  std::size_t dimension_of(std::size_t variable);
  Interval one_turn(std::size_t variable) const;
  std::vector<double> motions(const Bounds& bounds, const Transform& frame,
                              const std::vector<Transform>& joints,
                              const std::vector<double>& halves, bool of_a) const;
  /// Between spheres round the links, in cells.
  double least_gap(const Transform& frame) const;
  Transform frame_at(const std::vector<double>& point) const;

  const Model& model_;
  const MeshType& a_;
  const MeshType& b_;
  double cell_;
  JointsBetween joints_;
  Bounds bounds_a_;
  Bounds bounds_b_;
  std::vector<PathJoint> path_;
  std::vector<Dimension> dimensions_;
  std::vector<double> middle_;
};

// Compiled once.
extern template class BasicPairSpace<WholeMesh>;
extern template class BasicPairSpace<Mesh>;

/// Pairs are decided in it.
using PairLink = BasicPairLink<WholeMesh>;
using PairSpace = BasicPairSpace<WholeMesh>;
/// A guard's distance tables are made in it.
using FirmwarePairSpace = BasicPairSpace<Mesh>;

}  // namespace flashbvh::tool
