// A page about a trajectory: what `flashbvh guard --report` writes.
#ifndef FLASHBVH_TOOLS_REPORT_GUARD_PAGE_HPP
#define FLASHBVH_TOOLS_REPORT_GUARD_PAGE_HPP

#include <string>
#include <vector>

#include "robot/replay.hpp"

namespace flashbvh::tool {

/// A trajectory that was replayed; all outlives the page's making.
struct GuardedTrajectory {
  const Model& model;
  const Robot& robot;
  const Trajectory& trajectory;
  const std::vector<GuardAnswer>& answers;
  std::uint32_t work;  ///< what a period may spend; kAllWork: what it takes
  const std::vector<CertifiedMotion>& motions;  ///< from line to line; may be none
};

/// One self-contained HTML file, the same bytes for the same robot and trajectory: periods by
/// verdict, distances and work over time, the closest moment as pictures, motions.
std::string guard_page(const GuardedTrajectory& guarded);

/// Of the page: motions from line to line, those that are free one after the other in one row.
/// Nothing if there are none.
std::string motion_section(const GuardedTrajectory& guarded);
std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair);

}  // namespace flashbvh::tool

#endif
