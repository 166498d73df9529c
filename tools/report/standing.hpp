// Whether meshes touch, by firmware's queries: what the page of images says first.
#pragma once

#include <string>
#include <vector>

#include "report/page.hpp"

namespace flashbvh::tool {

/// B at the poses of `costs`, or as drawn. UserError if a query is refused.
std::vector<Standing> standings_of(const ImageFile& a, const ImageFile& b,
                                   const std::vector<PoseCost>& poses);

/// A line a pair, as HTML, those that touch first, then the nearest: "peg does not touch ring: 3.2
/// mm apart, as drawn". Nothing without pairs.
std::string standing_decisions(const std::vector<QueriedPair>& pairs);

/// Of poses that were given: where B is at each of the first. Nothing if none were.
std::string poses_table(const std::vector<QueriedPair>& pairs);

/// A digit a pose, as the colours of verdicts have them.
std::string verdicts_of(const std::vector<Standing>& standings);

}  // namespace flashbvh::tool
