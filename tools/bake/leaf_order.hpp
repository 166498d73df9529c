// Which triangle of a leaf comes first: the one whose slabs reject most
// (lib/docs/design.md, section 6).
#pragma once

#include <cstdint>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::bake {

/// A leaf's triangles, that one first and the others as they were. In integers, the first of
/// equals, so the result is the same on every machine.
std::vector<std::uint32_t> leaf_order(const LatticeMesh& mesh,
                                      std::vector<std::uint32_t> triangles);

}  // namespace flashbvh::bake
