// Whether meshes touch, by firmware's queries: the first result on the page of images.
#pragma once

#include <string>
#include <vector>

#include "report/page.hpp"

namespace flashbvh::tool {

/// B at the given poses, or as drawn. UserError if a query is refused.
std::vector<Standing> standings_of(const ImageFile& a, const ImageFile& b,
                                   const std::vector<PoseCost>& poses);

/// HTML with one line per pair, touching pairs first, then the nearest: "peg does not touch ring:
/// 3.2 mm apart, as drawn". Empty without pairs.
std::string standing_decisions(const std::vector<QueriedPair>& pairs);

/// A table of B at the first given poses; empty if none were given.
std::string poses_table(const std::vector<QueriedPair>& pairs);

/// One digit per pose, for the colours of verdicts.
std::string verdicts_of(const std::vector<Standing>& standings);

}  // namespace flashbvh::tool
