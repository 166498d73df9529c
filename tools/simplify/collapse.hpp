// Edges of a coarse mesh collapsed as long as the certificate holds: Garland and Heckbert, "Surface
// simplification using quadric error metrics", SIGGRAPH 1997, for the order; what is allowed is
// decided by what the original needs (deviation.hpp), collapse by collapse.
#pragma once

#include <vector>

#include "simplify/deviation.hpp"

namespace flashbvh::simplify {

/// Makes one vertex of two of `coarse`, on the lattice of `cell`, and leaves out what has no area
/// then; one try a vertex that is changed, or is next to one that is. `is_changed`: of each vertex;
/// afterwards, by this call. What failed once and has not changed would fail again.
/// `parts`: all of the original, covered by triangles of it; each stays within `limit` of one, and
/// no triangle that is moved is farther than that from the original. A mesh that is closed stays
/// so. Returns how many vertices went. Deterministic.
std::size_t collapse_edges(bake::SourceMesh& coarse, const std::vector<CoveredPart>& parts,
                           const NearestTriangle& original, double cell, double limit,
                           std::vector<bool>& is_changed);

}  // namespace flashbvh::simplify
