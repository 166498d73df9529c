// Output of flashbvh guard about a trajectory, in parts that text and JSON share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/robot/robot_output.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {

/// A robot, and a trajectory that it was guarded along.
struct GuardedTrajectory {
  Model model;  ///< of the URDF, or of the image
  std::unique_ptr<RobotFile> file;
  std::string path;  ///< of the trajectory
  Trajectory trajectory;
  std::vector<std::string> inputs;  ///< all files that were read
  std::vector<GuardAnswer> answers{};
  std::vector<LimitAnswer> limits{};  ///< of --limit, or empty
  Trajectory wanted{};  ///< with --limit the file's, and `trajectory` what was granted
  bool has_motions = false;
  std::vector<CertifiedMotion> motions{};  ///< from line to line; may be empty
  Json cost{};                             ///< of cost_json(), if requested

  const Robot& robot() const { return file->robot(); }
};

/// "upper - fore": the links of a pair.
std::string links_of(const GuardedTrajectory& guarded, std::uint16_t pair);

/// The trajectory as a CSV that read_trajectory() reads.
std::string trajectory_csv(const GuardedTrajectory& guarded);
/// The periods of each of limit()'s verdicts, and the first that was not all granted.
Json limits_json(const GuardedTrajectory& guarded);

/// The error in the values of a period, and how to fix it.
std::string why_refused(const GuardedTrajectory& guarded, std::size_t period);

/// "first at line 3, upper - fore": the first period of a kind that has one.
std::string first_of(const GuardedTrajectory& guarded, const ReplaySummary& summary,
                     std::size_t kind);

Json stretches_json(const GuardedTrajectory& guarded, const std::vector<Stretch>& stretches);
/// Estimates the instructions of the periods on a core, and the work that fits `a_period`
/// instructions.
Json cost_json(const GuardedTrajectory& guarded, const std::string& core, double a_period);
void print_cost(const Json& cost);

/// The motions that are not free.
Json motions_json(const GuardedTrajectory& guarded);
/// Facts about the whole trajectory, for the first line of --json and for the page.
Json guarded_facts(const GuardedTrajectory& guarded);
/// Prints an object per line of the trajectory; the first also contains the facts.
void print_guarded_json(const GuardedTrajectory& guarded);

/// One self-contained HTML file, the same bytes for the same robot and trajectory.
std::string guard_page(const GuardedTrajectory& guarded);

}  // namespace flashbvh::tool
