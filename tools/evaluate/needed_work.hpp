// The work of queries at given poses, the upper limits of its cost on a core, and the maximum for
// any pose: all boxes overlap.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
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

/// The value of NAME_TREE_SIZE in a baked header.
TreeSize tree_size(const ImageHeader& header);

/// A core by its name in the documents, and its proven costs.
struct Core {
  const char* name;
  RunCosts costs;
};

/// The cores of time_bound.hpp.
#define FLASHBVH_CORE_OF(core, c_name, text, ...) {text, k##core},
inline constexpr Core kCores[] = {FLASHBVH_FOR_EACH_CORE(FLASHBVH_CORE_OF)};
#undef FLASHBVH_CORE_OF

struct VisitBound {
  std::uint64_t visits = 0;
  std::uint64_t leaf_pairs = 0;      ///< among the visits
  std::uint64_t triangle_pairs = 0;  ///< tested at these leaf pairs
  std::uint64_t work = 0;
};

/// Attained if all boxes overlap: exact for `ranked`. For the others, which use other orders, it is
/// at most twice the visits if no node has a single child.
/// Precondition: both trees are of one kind, and walks(algorithm, their layout). O(nodes).
VisitBound visit_bound(const AnyTree& a, const AnyTree& b, const std::string& algorithm);

}  // namespace flashbvh::tool
