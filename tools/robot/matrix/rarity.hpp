// Estimates how rare collisions are among random configurations, and how likely a collision matrix
// by sampling is to miss them.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/status.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/matrix.hpp"

namespace flashbvh::tool {

/// Two bodies of a pair, and the id of a triangle of each.
struct BodyTriangles {
  std::size_t a;
  std::size_t b;
  TrianglePair<WholeMesh::Index> triangles;
};
/// Triangles that intersect at the pair's witness. `meshes`: of all the model's links.
BodyTriangles triangles_at(const Model& model, const WholeMesh* meshes, double cell,
                           const PairVerdict& pair);

/// The configurations at which a pair intersects.
struct Collisions {
  std::uint32_t count = 0;
  std::uint32_t of = 0;  ///< number of random configurations
};

/// For each pair, at configurations uniform within the limits and equal in every run: `samples`,
/// and ten times as many for pairs with fewer than ten collisions. Tests only pairs that are `can`.
/// `meshes`: of the links.
std::vector<Collisions> collisions_of(const Model& model, const WholeMesh* meshes, double cell,
                                      const std::vector<PairVerdict>& pairs, std::uint32_t samples);

/// The part of all configurations that collide, estimated from samples.
struct Share {
  double part;
  bool is_bound;  ///< no sample collides: the part is below this, with a confidence of 95 %
};
Share share_of(const Collisions& collisions);

/// The probability that this many samples find no collision.
double missed_by(std::uint32_t samples, const Share& share);

}  // namespace flashbvh::tool
