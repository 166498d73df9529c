// Makes the slabs of a leaf: lib/docs/design.md, section 6.
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// The two slabs that hold the leaf's triangles. The first is the thinnest along a triangle's
/// normal or the sum of all normals, the second the thinnest across an edge in that plane; zeros
/// for a leaf without area. In integers, ties by order: the result is the same on every machine.
LeafSlabs leaf_slabs(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace flashbvh::bake
