// The most that a query on two trees can visit, and the most work that it can take, whatever the
// pose: if all boxes overlap.
#ifndef FLASHBVH_TOOLS_EVALUATE_VISIT_BOUND_HPP
#define FLASHBVH_TOOLS_EVALUATE_VISIT_BOUND_HPP

#include <cstdint>
#include <string>

#include "image/image_file.hpp"

namespace flashbvh::tool {

struct VisitBound {
  std::uint64_t visits = 0;
  std::uint64_t leaf_pairs = 0;      ///< of the visits
  std::uint64_t triangle_pairs = 0;  ///< that are tested at these
  std::uint64_t work = 0;
};

/// Attained where all boxes overlap: exact for `ranked` and `ranked-stack`; for the others, which
/// follow other orders, at most twice what they visit then if no node has a single child.
/// Precondition: both trees are of one kind, and walks(algorithm, their layout). O(nodes).
VisitBound visit_bound(const AnyTree& a, const AnyTree& b, const std::string& algorithm);

}  // namespace flashbvh::tool

#endif
