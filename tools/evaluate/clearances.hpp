// Distances of images, by the firmware's own queries.
#ifndef FLASHBVH_TOOLS_EVALUATE_CLEARANCES_HPP
#define FLASHBVH_TOOLS_EVALUATE_CLEARANCES_HPP

#include <cstdint>
#include <vector>

#include "evaluate/queries.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Of two triangles, in cells of A's frame as it was drawn.
struct NearestPair {
  FoundPair triangles;
  double distance;  ///< to the nearest double
  NearestPoints points;
};

struct ClearanceAnswer {
  Status status = Status::done;
  bool in_range = true;              ///< false: of the distance only both bounds are known
  std::uint32_t lower = 0;           ///< of a distance, in 1/256 cell
  std::uint32_t upper = UINT32_MAX;  ///< UINT32_MAX: so much or more
  std::vector<NearestPair> nearest;  ///< one, or none; within a distance: all, sorted
  std::uint64_t visits = 0;
  std::uint64_t triangle_pairs = 0;  ///< tested
};

/// UserError, with the remedy, if `image` is pre-indexed: distances walk post-indexed trees.
void check_has_clearance(const ImageFile& image);

/// The distance, for each pose with the nearest pair before as its hint: `hint` is changed. Both
/// trees are of one kind, post-indexed.
ClearanceAnswer clearance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                          Witness<std::uint32_t>& hint);

/// Pairs within a distance, in 1/256 cell; only the first if not `all`.
ClearanceAnswer within_distance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                                std::uint32_t distance, bool all);

}  // namespace flashbvh::tool

#endif
