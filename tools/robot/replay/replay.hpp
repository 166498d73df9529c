// Replays a trajectory with firmware's code, robot and values, equal in every bit. Reports where
// the guard's verdict is not `free`, and for which pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/motion.hpp"
#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Joint values over time, from a CSV file.
///
/// The first line names the columns' variables, in any order. Each other line has their values one
/// period after the line before: radians, or metres for prismatic joints. '#' begins a comment.
/// Columns of mimics are checked, but not used; those without a name are not used. The first column
/// of times, if all its values are numbers, labels the lines; it sets no period.
struct Trajectory {
  std::size_t variables;
  std::vector<std::size_t> lines{};  ///< of each period: its line in the file, from 1
  std::vector<float> all_values{};   ///< of each period
  std::vector<double> times{};       ///< of each period, in the unit of their column; or empty
  std::string time_name{};

  std::size_t size() const { return lines.size(); }
  /// One value per variable, in the model's order, as floats: firmware's input.
  const float* values(std::size_t period) const { return &all_values[period * variables]; }
};

/// UserError, with the line, the column and the remedy, unless each variable has one column, all
/// values are numbers, and times don't decrease. Mimics have to follow their joints within 0.001
/// rad or m, times the multiplier if it is above 1. Does not check limits. Warns of unused columns
/// of times, and of the first uneven step of the used one.
Trajectory read_trajectory(const std::string& path, const Model& model, Warnings& warnings);

/// Unlimited work. With UINT32_MAX, the guard does not report the work spent.
constexpr std::uint32_t kAllWork = UINT32_MAX - 1;

/// The guard's answers in each period, with `work` per period. The first period whose values are
/// accepted primes the guard and gets unlimited work.
std::vector<GuardAnswer> replay(const Robot& robot, const Trajectory& trajectory,
                                std::uint32_t work);

/// replay() of a robot that goes where Guard::limit() lets it, from each line towards the next one.
/// Sets the trajectory's values to those granted, and `limits` to what limit() answers. `work`: for
/// each of both calls, whose work adds up in the answers. Where limit() refuses values the robot
/// stands still.
std::vector<GuardAnswer> replay_limited(const Robot& robot, Trajectory& trajectory,
                                        std::uint32_t work, std::vector<LimitAnswer>& limits);

/// The motion from the line before to this one.
struct CertifiedMotion {
  MotionAnswer answer;
  double part;                 ///< fraction of the motion at which it hits or is close
  std::vector<double> values;  ///< of the variables there, in radians and metres
};

/// The motions between all lines: one less than lines. A motion's status is not `done` if firmware
/// refuses one of its ends.
std::vector<CertifiedMotion> certify(const Robot& robot, const Trajectory& trajectory);

/// The line at which two links are nearest. Does not check between lines.
struct ClosestMoment {
  std::size_t period;
  std::uint16_t pair;   ///< index in Robot::pairs
  std::uint32_t lower;  ///< lower bound of their distance, in 1/256 cell
};

/// The first of the nearest moments; none if no pair is guarded, no values are accepted, or all
/// pairs are too far apart to be measured.
std::optional<ClosestMoment> closest_moment(const Robot& robot, const Trajectory& trajectory);

/// The first joint whose value firmware refuses. Precondition: there is one.
std::size_t refused_joint(const Robot& robot, const float* values);

/// The verdicts, and refused values.
constexpr std::size_t kPeriodKinds = 6;
constexpr std::size_t kRefusedKind = 5;
/// In the order of tables.
constexpr std::array<std::size_t, kPeriodKinds> kKindsInOrder = {0, 1, 2, 4, 3, 5};
constexpr std::array<const char*, kPeriodKinds> kKindNames = {"free",          "warn", "leaving",
                                                              "not yet known", "stop", "refused"};
std::size_t kind_of(const GuardAnswer& answer);
/// "free", "hit", "close".
const char* outcome_name(MotionOutcome outcome);
bool is_free(const CertifiedMotion& motion);

struct ReplaySummary {
  std::array<std::size_t, kPeriodKinds> periods{};
  std::array<std::size_t, kPeriodKinds> first{};  ///< first period of each kind
  bool is_primed = false;                         ///< if not, there is no work
  std::uint32_t priming = 0;
  double mean = 0;       ///< work of the periods after the priming one
  double with_work = 0;  ///< the part of these periods with any work
  std::uint32_t percentile_999 = 0;
  std::uint32_t most = 0;
};

ReplaySummary summary_of(const std::vector<GuardAnswer>& answers);

/// The poses and distances of a robot's pairs of links at the values of a period.
class PosedPairs {
 public:
  /// `robot` must outlive the object.
  explicit PosedPairs(const Robot& robot)
      : robot_(robot),
        coordinates_(robot.joint_count),
        frames_(robot.joint_count),
        nearest_(robot.pair_count) {}

  /// Sets the values. False if firmware refuses them.
  bool take(const float* floats);

  Pose pose(const RobotPair& pair) const {
    return relative_pose(frame_of(pair.a), frame_of(pair.b));
  }

  /// In 1/256 cell, rounded down; none if it is out of range. The last nearest pair is the hint.
  std::optional<std::uint32_t> distance_of(std::uint16_t pair);

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

/// Successive periods with one verdict, other than `free`, for one pair.
struct Stretch {
  std::size_t first;  ///< periods
  std::size_t last;
  std::size_t kind;    ///< as of kind_of()
  std::uint16_t pair;  ///< index in Robot::pairs; kNoPair for refused values
  std::uint32_t kept;  ///< the guard's lower bound on the pair's distance, in 1/256 cell
  std::optional<std::uint32_t> closest;  ///< of the pair at these lines; none: not measured
};

/// All stretches, in order.
std::vector<Stretch> stretches_of(const Robot& robot, const Trajectory& trajectory,
                                  const std::vector<GuardAnswer>& answers);

/// At most `most` stretches, in order: prefers those that stop, then the longest.
std::vector<Stretch> worst_of(std::vector<Stretch> stretches, std::size_t most);

}  // namespace flashbvh::tool
