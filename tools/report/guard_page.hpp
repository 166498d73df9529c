// The page about a trajectory that `flashbvh guard --report` writes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/matrix/unguarded.hpp"
#include "robot/replay/period_costs.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {

/// A replayed trajectory; all references must stay valid while the page is made.
struct GuardedTrajectory {
  const Model& model;
  const Robot& robot;
  const std::vector<std::uint32_t>& image;
  const std::string& path;  ///< path of the trajectory
  const Trajectory& trajectory;
  const std::vector<GuardAnswer>& answers;
  std::uint32_t work;  ///< the budget of a period; kAllWork: no limit
  bool has_motions;
  const std::vector<CertifiedMotion>& motions;  ///< from line to line; may be empty
  const std::vector<UnguardedPair>& unguarded;
  const std::optional<GuardTiming>& timing;
};

/// One self-contained HTML file, the same bytes for the same robot and trajectory: the result,
/// periods by verdict, their time on a core, distances and work over time, pairs and stretches that
/// are not free, the closest moment, motions; the robot, moved through all of it.
std::string guard_page(const GuardedTrajectory& guarded);

/// The largest number of pairs drawn as lines: the first near pairs, numbered from 1.
constexpr std::size_t kMostLines = 6;
/// The section of distances and work over time.
std::string chart_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near);

std::string pair_name(const GuardedTrajectory& guarded, std::size_t pair);
double metres_of(const GuardedTrajectory& guarded, std::uint32_t fine);

}  // namespace flashbvh::tool
