// Certifies how far a mesh deviates from a coarser one, instead of an estimate.
//
// The distance to a triangle is a convex function, so over a triangle it is largest at a corner. A
// triangle that is too far from a coarse one is cut. So the certificate covers each point of the
// mesh, not samples of it: Guthe, Borodin and Klein, "Fast and accurate Hausdorff distance
// calculation between meshes", Journal of WSCG 13, 2005.
#pragma once

#include <cstdint>
#include <vector>

#include "simplify/nearest.hpp"

namespace flashbvh::simplify {

struct Deviation {
  /// No point of the mesh is farther from the coarse one. At most kTightness times the distance of
  /// `where`, or a 1/32 of the limit. Infinite if a point exceeds the limit, or very nearly does.
  double most = 0;
  double at_least = 0;  ///< the distance of `where`
  Point where{};
};

/// A part of the mesh that is within the limit of one triangle of the coarse mesh.
struct CoveredPart {
  PointTriangle part;
  std::uint32_t by;  ///< argument of NearestTriangle::triangle()
};

constexpr double kTightness = 1.02;

/// A bound on the error of a distance from points of `mesh`, by the rounding of doubles. A
/// certificate adds it to each distance.
double arithmetic_error(const bake::SourceMesh& mesh);
/// A certificate confirms a distance, computed another way, if it is below the limit by this many
/// arithmetic errors: one of the computed distance, one of its own, and the one that it adds.
constexpr double kErrors = 3;

/// `mesh` and the coarse mesh are in the same frame and unit. Gives up at a point farther than
/// `limit`. O(n log m) except where the two meshes cross edges of each other.
Deviation deviation_from(const NearestTriangle& coarse, const bake::SourceMesh& mesh, double limit,
                         std::vector<CoveredPart>* parts = nullptr);

/// A certificate's bound on how far points of `mesh` are from `kept`, which is in the same frame
/// and unit and has a triangle; tight, and never infinite.
double farthest_from(const bake::SourceMesh& kept, const bake::SourceMesh& mesh);

/// The deviation of both meshes from each other, equally tight if far below the limit.
Deviation deviation_between(const bake::SourceMesh& mesh, const bake::SourceMesh& coarse,
                            double limit);

}  // namespace flashbvh::simplify
