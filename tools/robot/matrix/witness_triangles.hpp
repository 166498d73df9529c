// The triangles that a witness of a pair's collision shows.
#pragma once

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

}  // namespace flashbvh::tool
