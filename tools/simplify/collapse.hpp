// Collapses edges of a coarse mesh while the certificate holds. The order is that of Garland and
// Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997. The deviation from
// the original (deviation.hpp) allows or refuses each collapse.
#pragma once

#include <vector>

#include "simplify/deviation.hpp"
#include "text/deadline.hpp"

namespace flashbvh::simplify {

/// Merges pairs of vertices of `coarse`, on the lattice of `cell`, and removes triangles that lose
/// their area. Tries each vertex once if it or a neighbour has changed; failed collapses would fail
/// again without a change. `is_changed`: of each vertex; returns the changes by this call.
/// `parts`: all of the original, covered by triangles of `coarse`. Each stays within `limit` of
/// one, and no moved triangle is farther than `limit` from the original, up to
/// arithmetic_error(). So pass the certificate's limit less kErrors of these. A closed mesh stays
/// closed. Returns the number of removed vertices. Deterministic, unless the deadline passes: then
/// it ends early.
std::size_t collapse_edges(bake::SourceMesh& coarse, const std::vector<CoveredPart>& parts,
                           const NearestTriangle& original, double cell, double limit,
                           std::vector<bool>& is_changed, const tool::Deadline& deadline);

}  // namespace flashbvh::simplify
