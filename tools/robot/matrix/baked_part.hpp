// A mesh that a proof needs: baked, kept in memory, never written.
#pragma once

#include "bake/baked_tree.hpp"
#include "bake/mesh.hpp"

namespace flashbvh::tool {

using BakedPart = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

/// Of a mesh with at least one triangle. UserError if it does not fit the lattice or 16-bit
/// indices.
BakedPart bake_part(const bake::SourceMesh& mesh, double cell);

/// The triangles with these numbers, and their vertices alone.
bake::SourceMesh part_of(const bake::SourceMesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace flashbvh::tool
