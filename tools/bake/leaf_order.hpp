// Chooses the first triangle of a leaf: the one whose slabs reject most
// (lib/docs/design.md, section 6).
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// A leaf's triangles, that one first and the others in their order. In integers, ties by order:
/// the result is the same on every machine.
std::vector<std::uint32_t> leaf_order(const LatticeMesh& mesh,
                                      std::vector<std::uint32_t> triangles);

}  // namespace flashbvh::bake
