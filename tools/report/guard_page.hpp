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
};

/// One self-contained HTML file, the same bytes for the same robot and trajectory: periods by
/// verdict, distances over time, the closest moment as pictures.
std::string guard_page(const GuardedTrajectory& guarded);

}  // namespace flashbvh::tool

#endif
