// A robot at the closest moment of its trajectory, as pictures.
#ifndef FLASHBVH_TOOLS_REPORT_CLOSEST_PICTURES_HPP
#define FLASHBVH_TOOLS_REPORT_CLOSEST_PICTURES_HPP

#include <string>

#include "report/guard_page.hpp"

namespace flashbvh::tool {

/// All links, and the two that are nearest from near, their nearest triangles lit: HTML.
std::string closest_pictures(const GuardedTrajectory& guarded, const ClosestMoment& closest);

}  // namespace flashbvh::tool

#endif
