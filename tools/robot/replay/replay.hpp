// A trajectory through the code that firmware runs: the same robot, the same values, the same bits.
//
// The poses and distances of a robot's pairs of links at the values of a period.
#ifndef FLASHBVH_TOOLS_ROBOT_REPLAY_REPLAY_HPP
#define FLASHBVH_TOOLS_ROBOT_REPLAY_REPLAY_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/motion.hpp"
#include "robot/replay/trajectory.hpp"

namespace flashbvh::tool {

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

}  // namespace flashbvh::tool

#endif
