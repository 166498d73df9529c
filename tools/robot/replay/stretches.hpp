// Where along a trajectory the guard does not say `free`, and of which pairs.
#ifndef FLASHBVH_TOOLS_ROBOT_REPLAY_STRETCHES_HPP
#define FLASHBVH_TOOLS_ROBOT_REPLAY_STRETCHES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot/replay/replay.hpp"

namespace flashbvh::tool {

/// Periods one after the other with one verdict, other than `free`, of one pair.
struct Stretch {
  std::size_t first;  ///< periods
  std::size_t last;
  std::size_t kind;    ///< of replay_summary.hpp
  std::uint16_t pair;  ///< of Robot::pairs; kNoPair of values that are refused
  std::uint32_t kept;  ///< what the guard knows of the pair's distance, in 1/256 cell
  std::optional<std::uint32_t> closest;  ///< of the pair at these lines; none: not measured
};

/// All of them, in order.
std::vector<Stretch> stretches_of(const Robot& robot, const Trajectory& trajectory,
                                  const std::vector<GuardAnswer>& answers);

/// At most `most` of them, in order: those that stop before the others, the longest first.
std::vector<Stretch> worst_of(std::vector<Stretch> stretches, std::size_t most);

/// A pair that is not free in some period, by a guard of its own with all the work it takes, or
/// that the robot's guard names as not yet known, or that comes within its warn distance at a line.
struct NearPair {
  std::uint16_t pair;
  std::array<std::size_t, kPeriodKinds> named{};  ///< periods by verdict, but `free`
  std::size_t within_stop = 0;                    ///< lines
  std::size_t within_warn = 0;
  std::optional<std::uint32_t> closest;  ///< at a line, in 1/256 cell; none: out of range
  std::size_t closest_period = 0;
};

/// All of them: those that stop for the most periods or lines first, then those that are not yet
/// known, then those that are warned of.
std::vector<NearPair> near_pairs(const Robot& robot, const Trajectory& trajectory,
                                 const std::vector<GuardAnswer>& answers);

}  // namespace flashbvh::tool

#endif
