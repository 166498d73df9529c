// The default tree against the paper's, by visits: how much is won, and how much is left.
#ifndef FLASHBVH_TOOLS_EVALUATE_DEFAULT_TREE_HPP
#define FLASHBVH_TOOLS_EVALUATE_DEFAULT_TREE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/objects.hpp"
#include "evaluate/setups.hpp"

namespace flashbvh::tool {

/// The visits of one setup, or of several together.
struct DefaultTreeVisits {
  std::uint64_t stackless = 0;  ///< on the paper's tree
  std::uint64_t ranked = 0;     ///< on the default tree
  std::uint64_t best_rule = 0;  ///< on the default tree: the fewest that any rule needs

  double ranked_to_stackless() const;
  double ranked_to_best() const;
};

struct DefaultTreeResult {
  const scene::Setup* setup;
  bool intersecting;  ///< whether triangles intersect
  DefaultTreeVisits visits;
};

/// Geometry tests and all. Seconds for the largest setups: the best rule takes the most.
DefaultTreeResult compare_default_tree(const scene::Setup& setup, Objects& objects);

/// The sum over all setups, or over those whose triangles intersect.
DefaultTreeVisits sum_of(const std::vector<DefaultTreeResult>& results, bool only_intersecting);

/// A line a setup and the sums, as text.
std::string default_tree_table(const std::vector<DefaultTreeResult>& results);

}  // namespace flashbvh::tool

#endif
