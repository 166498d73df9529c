// What `flashbvh guard` prints.
#ifndef FLASHBVH_TOOLS_CLI_GUARD_OUTPUT_HPP
#define FLASHBVH_TOOLS_CLI_GUARD_OUTPUT_HPP

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/robot/baked_robot.hpp"
#include "robot/replay/replay.hpp"

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

/// Most lines that tables and standard error list one by one.
constexpr std::size_t kShownLines = 10;

/// "ok" of `done`.
std::string name_of(Status status);
const std::string& link_name(const BakedRobot& robot, std::uint8_t link);
const std::string& variable_name(const BakedRobot& robot, std::size_t variable);

/// Pairs that are not guarded, counts, stretches that are not free, the closest moment, work, and
/// motions that are not free.
void print_replayed(const Replayed& replayed);
/// One object a line of the trajectory; the first has the pairs that are not guarded, too.
void print_replayed_json(const Replayed& replayed);
/// Values that firmware refuses, on standard error.
void print_refused(const Replayed& replayed);

/// kCheckFailed if any period is `stop` or `not_yet_known`, or a motion not free; kRefusedValues
/// if firmware refuses any values.
ExitCode exit_code_of(const Replayed& replayed);

}  // namespace flashbvh::tool

#endif
