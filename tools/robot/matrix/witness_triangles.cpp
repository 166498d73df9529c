#include "robot/matrix/witness_triangles.hpp"

#include "flashbvh/collide.hpp"

namespace flashbvh::tool {

BodyTriangles triangles_at(const Model& model, const WholeMesh* meshes, double cell,
                           const PairVerdict& pair) {
  TrianglePair<WholeMesh::Index> found{};
  const Transform frame = frame_between(model, joints_between(model, pair.a, pair.b), pair.witness);
  for (const auto& [a, b] : pair.bodies) {
    if (first_pair(meshes[a], meshes[b], pose_of(frame, cell), found).yes) {
      return {a, b, found};
    }
  }
  return {pair.a, pair.b, found};
}

}  // namespace flashbvh::tool
