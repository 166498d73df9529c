// The work of queries at given poses, and the most for any pose: all boxes overlap.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Statistics of the work of queries at some poses.
struct NeededWork {
  std::uint64_t most = 0;
  std::uint64_t percentile_99 = 0;  ///< 99 of 100 queries needed no more
  double mean = 0;
};

/// Precondition: `work` is not empty.
NeededWork needed_work(std::vector<std::uint64_t> work);

struct VisitBound {
  std::uint64_t visits = 0;
  std::uint64_t leaf_pairs = 0;      ///< among the visits
  std::uint64_t triangle_pairs = 0;  ///< tested at these leaf pairs
  std::uint64_t work = 0;
};

/// Attained if all boxes overlap: exact for `ranked`, of post-indexed trees. For `stackless`, of
/// pre-indexed ones, at most twice the visits if no node has a single child. O(nodes).
/// Precondition: both trees are of one kind.
VisitBound visit_bound(const AnyTree& a, const AnyTree& b);

}  // namespace flashbvh::tool
