// A trajectory through the code that firmware runs: the same robot, the same values, the same bits;
// and where along it the guard does not say `free`, and of which pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/motion.hpp"
#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Joint values over time, as a CSV file has them.
///
/// The first line names a variable in each column, in any order; each other line has their values
/// one period after the line before: radians, metres of joints that slide. '#' begins a comment.
/// Fields lie between semicolons, commas or tabs. Columns of joints that mimic are checked and not
/// used. The first column of times, if all its values are numbers, names the lines; it sets no
/// period.
class Trajectory {
 public:
  explicit Trajectory(std::size_t variables) : variables_(variables) {}

  std::size_t size() const { return lines_.size(); }
  /// Of the file, from 1.
  std::size_t line(std::size_t period) const { return lines_[period]; }
  /// A value a variable, in the order of the model's, as floats: the input of firmware.
  const float* values(std::size_t period) const { return &values_[period * variables_]; }
  std::size_t variables() const { return variables_; }

  bool has_times() const { return !times_.empty(); }
  /// Of the column of times, in its unit. Precondition: has_times().
  double time(std::size_t period) const { return times_[period]; }
  const std::string& time_name() const { return time_name_; }

  /// `times`: one a line.
  void set_times(std::string name, std::vector<double> times) {
    time_name_ = std::move(name);
    times_ = std::move(times);
  }
  void add(std::size_t line, const std::vector<float>& values) {
    lines_.push_back(line);
    values_.insert(values_.end(), values.begin(), values.end());
  }

 private:
  std::size_t variables_;
  std::vector<std::size_t> lines_;
  std::vector<float> values_;
  std::string time_name_;
  std::vector<double> times_;
};

/// UserError, with the line, the column and the remedy, unless each variable has one column, all
/// values are numbers, times don't go back, and mimics are where their joints put them: within
/// 0.001 rad or m, times the multiplier where it is above 1. Limits are not looked at. Warns of
/// columns of times that are not used, and of the first uneven step of the one that is.
Trajectory read_trajectory(const std::string& path, const Model& model, Warnings& warnings);

/// Whatever a period takes; of UINT32_MAX the guard does not report what was spent.
constexpr std::uint32_t kAllWork = UINT32_MAX - 1;

/// What the guard answers in each period, with so much work each; all that the first one takes
/// whose values are accepted, which primes it.
std::vector<GuardAnswer> replay(const Robot& robot, const Trajectory& trajectory,
                                std::uint32_t work);

/// From the line before to this one.
struct CertifiedMotion {
  MotionAnswer answer;
  double part;                 ///< of the way, where it hits or is close
  std::vector<double> values;  ///< there, one a variable, in radians and metres
};

/// Between all lines: one less than there are lines. A motion ends with a status other than `done`
/// if firmware refuses one of its ends.
std::vector<CertifiedMotion> certify(const Robot& robot, const Trajectory& trajectory);

/// Where two links are nearest of all lines, between which is not looked.
struct ClosestMoment {
  std::size_t period;
  std::uint16_t pair;  ///< of Robot::pairs
  Pose pose;           ///< of its second link in the frame of the first one's joint
  Clearance<std::uint16_t> clearance;
};

/// The first of the nearest; none if no pair is guarded, no values are accepted, or all are too far
/// apart to be measured.
std::optional<ClosestMoment> closest_moment(const Robot& robot, const Trajectory& trajectory);

/// By pair, by every `step`th line: how far the links are apart, in metres; none where values are
/// refused or the distance is out of range.
std::vector<std::vector<std::optional<double>>> distances_over(const Robot& robot,
                                                               const Trajectory& trajectory,
                                                               std::size_t step);

/// Where links lie in the base's frame. Precondition: firmware accepts the values.
std::vector<Pose> link_poses(const Robot& robot, const float* values);

/// The first joint whose value firmware refuses. Precondition: there is one.
std::size_t refused_joint(const Robot& robot, const float* values);

/// Those of Verdict, and values that are refused.
constexpr std::size_t kPeriodKinds = 5;
constexpr std::size_t kRefusedKind = 4;
/// In the order of tables, from the best to the worst.
constexpr std::array<std::size_t, kPeriodKinds> kKindsInOrder = {0, 1, 3, 2, 4};
constexpr std::array<const char*, kPeriodKinds> kKindNames = {"free", "warn", "not yet known",
                                                              "stop", "refused"};
std::size_t kind_of(const GuardAnswer& answer);
/// "free", "hit", "close".
const char* outcome_name(MotionOutcome outcome);
bool is_free(const CertifiedMotion& motion);

struct ReplaySummary {
  std::array<std::size_t, kPeriodKinds> periods{};
  std::array<std::size_t, kPeriodKinds> first{};  ///< the first of them
  bool is_primed = false;                         ///< else there is no work
  std::uint32_t priming = 0;
  double mean = 0;  ///< work of the periods after the one that primed
  std::uint32_t percentile_999 = 0;
  std::uint32_t most = 0;
};

ReplaySummary summary_of(const std::vector<GuardAnswer>& answers);

/// The poses and distances of a robot's pairs of links at the values of a period.
class PosedPairs {
 public:
  /// `robot` outlives it.
  explicit PosedPairs(const Robot& robot)
      : robot_(robot),
        coordinates_(robot.joint_count),
        frames_(robot.joint_count),
        nearest_(robot.pair_count) {}

  /// False if firmware refuses the values.
  bool take(const float* floats);

  Pose pose(const RobotPair& pair) const {
    return relative_pose(frame_of(pair.a), frame_of(pair.b));
  }
  Pose pose(std::uint8_t link) const { return relative_pose(kIdentityFrame, frame_of(link)); }

  /// In 1/256 cell, rounded down; none if it is out of range. The last one is the hint.
  std::optional<std::uint32_t> distance_of(std::uint16_t pair);
  bool is_within(std::uint16_t pair, std::uint32_t distance) const;

 private:
  const flashbvh::Frame& frame_of(std::uint8_t link) const {
    const std::uint8_t joint = robot_.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames_[joint];
  }

  const Robot& robot_;
  std::vector<JointCoordinate> coordinates_;
  std::vector<flashbvh::Frame> frames_;
  std::vector<Witness<std::uint16_t>> nearest_;  ///< of each pair
};

/// Periods one after the other with one verdict, other than `free`, of one pair.
struct Stretch {
  std::size_t first;  ///< periods
  std::size_t last;
  std::size_t kind;    ///< of a period
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
