// How far a mesh reaches from a coarser one: a certificate, not an estimate.
//
// The distance to a triangle is a convex function, so all of a triangle lies as near to a coarse
// one as the farthest of its corners does. Where that is not near enough it is cut in four. So each
// point of the mesh is covered, not samples of it: Guthe, Borodin and Klein, "Fast and accurate
// Hausdorff distance calculation between meshes", Journal of WSCG 13, 2005.
#pragma once

#include <cstdint>
#include <vector>

#include "simplify/nearest.hpp"

namespace flashbvh::simplify {

struct Deviation {
  /// No point of the mesh lies farther from the coarse one. At most kTightness times the distance
  /// of `where`, or a 1/32 of the limit. Infinite: a point does, or very nearly does.
  double most = 0;
  double at_least = 0;  ///< the distance of `where`
  Point where{};
};

/// A part of the mesh, all of which is within the limit of one triangle of the coarse one.
struct CoveredPart {
  PointTriangle part;
  std::uint32_t by;  ///< a place
};

constexpr double kTightness = 1.02;

/// `mesh` and the coarse mesh are in the same frame and unit. Gives up where a point is farther
/// than `limit`. O(n log m) but where the two meshes cross edges of each other.
Deviation deviation_from(const NearestTriangle& coarse, const bake::SourceMesh& mesh, double limit,
                         std::vector<CoveredPart>* parts = nullptr);

/// Of both meshes from each other, no less tight where they are far nearer than the limit.
Deviation deviation_between(const bake::SourceMesh& mesh, const bake::SourceMesh& coarse,
                            double limit);

}  // namespace flashbvh::simplify
