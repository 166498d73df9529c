// How rare collisions are among configurations drawn at random, as a collision matrix by sampling
// would see them.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/run_result.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/matrix.hpp"

namespace flashbvh::tool {

/// Where the links lie in the base's frame. `variables`: a value each. UserError as pose_of().
std::vector<Pose> link_poses(const Model& model, double cell, const std::vector<double>& variables);

/// Two of a pair's bodies, and a triangle of each by its id.
struct BodyTriangles {
  std::size_t a;
  std::size_t b;
  TrianglePair<WholeMesh::Index> triangles;
};
/// That intersect at the witness of a pair that has one. `meshes`: of all the model's links.
BodyTriangles triangles_at(const Model& model, const WholeMesh* meshes, double cell,
                           const PairVerdict& pair);

/// Configurations at which a pair intersects.
struct Collisions {
  std::uint32_t count = 0;
  std::uint32_t of = 0;  ///< so many, drawn at random
};

/// Of each pair, at configurations even within the limits and always the same: `samples`, and ten
/// times as many where fewer than ten of them collide. Pairs that are not `can` are not queried.
/// `meshes`: the links'.
std::vector<Collisions> collisions_of(const Model& model, const WholeMesh* meshes, double cell,
                                      const std::vector<PairVerdict>& pairs, std::uint32_t samples);

/// What part of all configurations collides, estimated from samples.
struct Share {
  double part;
  bool is_bound;  ///< none of the samples does: the part is below this, with a confidence of 95 %
};
Share share_of(const Collisions& collisions);

/// How likely so many samples find none.
double missed_by(std::uint32_t samples, const Share& share);

}  // namespace flashbvh::tool
