// Which triangle of a leaf comes first, and which of its edges: those whose slabs reject most
// (flashbvh/detail/leaf_shape.hpp).
#ifndef FLASHBVH_TOOLS_BAKE_LEAF_ORDER_HPP
#define FLASHBVH_TOOLS_BAKE_LEAF_ORDER_HPP

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

struct LeafTriangle {
  std::uint32_t id;         ///< its number in the source mesh
  TriangleCorners corners;  ///< turned on, never round
};

/// In integers, the first of equals, so the result is the same on every machine.
std::vector<LeafTriangle> leaf_order(const LatticeMesh& mesh,
                                     const std::vector<std::uint32_t>& triangles);

}  // namespace flashbvh::bake

#endif
