// Chooses the first triangle of a leaf: the one whose slabs reject most
// (lib/docs/design.md, section 6).
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// The range of the leaf's triangles along a direction.
struct LeafExtent {
  std::int64_t least;
  std::int64_t most;
};
LeafExtent extent_along(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                        const Point& direction);

/// That range's size, in 1/256 cell; one cell at least.
std::uint64_t thickness(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles,
                        const Point& direction);

/// A leaf's triangles, that one first and the others in their order. In integers, ties by order:
/// the result is the same on every machine.
std::vector<std::uint32_t> leaf_order(const LatticeMesh& mesh,
                                      std::vector<std::uint32_t> triangles);

}  // namespace flashbvh::bake
