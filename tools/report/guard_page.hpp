// A page about a trajectory: what `flashbvh guard --report` writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/matrix/unguarded.hpp"
#include "robot/replay/period_costs.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {

/// A trajectory that was replayed; all outlives the page's making.
struct GuardedTrajectory {
  const Model& model;
  const Robot& robot;
  const std::vector<std::uint32_t>& image;
  const std::string& path;  ///< of the trajectory
  const Trajectory& trajectory;
  const std::vector<GuardAnswer>& answers;
  std::uint32_t work;  ///< what a period may spend; kAllWork: what it takes
  bool has_motions;
  const std::vector<CertifiedMotion>& motions;  ///< from line to line; may be none
  const std::vector<UnguardedPair>& unguarded;
  const std::optional<GuardTiming>& timing;
};

/// One self-contained HTML file, the same bytes for the same robot and trajectory: what it comes
/// to, periods by verdict, their time on a core, distances and work over time, pairs and stretches
/// that are not free, the closest moment as pictures, motions.
std::string guard_page(const GuardedTrajectory& guarded);

/// Pairs that are drawn as lines: the first of the near pairs, by number from 1.
constexpr std::size_t kMostLines = 6;
/// Of the page: distances and work over time.
std::string chart_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near);

std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair);
double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine);

}  // namespace flashbvh::tool
