// The fewest visits that any traversal rule could need: the floor under every row of the tables.
#ifndef FLASHBVH_TOOLS_EVALUATE_BEST_RULE_HPP
#define FLASHBVH_TOOLS_EVALUATE_BEST_RULE_HPP

#include <cstdint>

#include "bake/build_tree.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::tool {

/// `translation`: of B in A's frame, in cells. A rule says for each pair of overlapping internal
/// nodes into which tree to descend; at a leaf there is no choice.
/// Time and memory: one table entry for each pair of overlapping nodes of which one is internal.
std::uint64_t best_rule_visits(const bake::BuildTree& a, const bake::BuildTree& b,
                               const Point& translation);

}  // namespace flashbvh::tool

#endif
