// What `flashbvh guard` prints.
#ifndef FLASHBVH_TOOLS_CLI_GUARD_OUTPUT_HPP
#define FLASHBVH_TOOLS_CLI_GUARD_OUTPUT_HPP

#include <string>
#include <vector>

#include "cli/baked_robot.hpp"
#include "cli/commands.hpp"
#include "robot/replay.hpp"

namespace flashbvh::tool {

/// A trajectory, and what came of it.
struct Replayed {
  const BakedRobot& robot;
  const std::string& path;  ///< of the trajectory
  const Trajectory& trajectory;
  std::vector<GuardAnswer> answers;  ///< one a period
  bool has_motions;
  std::vector<CertifiedMotion> motions;  ///< the first: to the second line
};

/// Counts, the closest moment, work, and motions that are not free.
void print_replayed(const Replayed& replayed);
/// One object a line of the trajectory.
void print_replayed_json(const Replayed& replayed);
/// Values that firmware refuses, on standard error.
void print_refused(const Replayed& replayed);

/// kCheckFailed if any period is `stop` or `not_yet_known`, or a motion not free; kRefusedValues
/// if firmware refuses any values.
ExitCode exit_code_of(const Replayed& replayed);

}  // namespace flashbvh::tool

#endif
