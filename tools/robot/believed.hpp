// Pairs of links that an SRDF disables: what is found of them, and which of them the user stands
// by.
#ifndef FLASHBVH_TOOLS_ROBOT_BELIEVED_HPP
#define FLASHBVH_TOOLS_ROBOT_BELIEVED_HPP

#include <string>
#include <vector>

#include "robot/matrix.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Marks the disabled pair of links `a` and `b` as believed. UserError, at `place`, if the SRDF
/// does not disable it.
void believe(std::size_t a, std::size_t b, const std::string& place, Model& model);

/// UserError, with the line of `srdf`, the joints' values and the fix, if a pair that is disabled
/// can collide and is not believed; names all such pairs. Warns of those that are undecided,
/// and of those that are believed for nothing.
void check_disabled(const Model& model, const std::vector<PairVerdict>& pairs,
                    const std::string& srdf, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
