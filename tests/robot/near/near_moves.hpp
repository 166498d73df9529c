// Small moves about poses in which an arm's links nearly touch, like those of welding or assembly
// arms, and the distances of all guarded pairs during the moves.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "flashbvh/robot/workcell.hpp"
#include "near_distances.hpp"
#include "support/arms/arms.hpp"

namespace flashbvh::test {

/// Lengths in metres, speeds per period.
struct NearOptions {
  double turn = 1.25e-3;      ///< top speed of turning joints, in radians
  double slide = 5e-4;        ///< top speed of sliding joints and of the obstacle
  bool has_obstacle = false;  ///< a moving one, at most 70 mm above the stop distance
};

using NearCell = WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>;

/// Joint values and the obstacle's frame at one moment.
struct NearMoment {
  Values values;
  Frame obstacle = kIdentityFrame;
};

/// The scene of a guard: a robot, and optionally an obstacle.
class NearScene {
 public:
  NearScene(const Robot& robot, const NearOptions& options);
  const Robot& robot() const { return workcell_.robot(); }
  bool has_obstacle() const { return link_ != kMaxLinks; }
  /// Moves the obstacle to `frame`, by at most `moved`, in 1/256 cell.
  void move(const Frame& frame, std::uint32_t moved);
  /// The poses of all pairs, B in A's frame, as the guard places them.
  std::vector<Pose> poses(const NearMoment& moment) const;
  NearOracle& oracle() const { return *oracle_; }

 private:
  void add_obstacle();

  std::unique_ptr<BakedArm> body_;
  tool::Model model_;
  std::unique_ptr<NearCell> memory_;
  Workcell workcell_;
  std::uint8_t link_ = kMaxLinks;
  std::unique_ptr<NearOracle> oracle_;
};

/// The distances of all pairs of placed meshes at a moment, in 1/256 cell, rounded down.
class NearDistances {
 public:
  NearDistances(const NearScene& scene, const NearMoment& moment);

  bool is_beyond(std::uint32_t pair, double limit) const;
  /// Whether all pairs exceed their stop distances by more than `excess`.
  bool are_over(std::int64_t excess) const;
  /// The least excess of a pair over its stop distance; may be negative. Ignores pairs of
  /// `is_ignored` that are beyond it.
  std::int64_t excess(const std::vector<bool>& is_ignored) const;

 private:
  std::int64_t distance(std::uint32_t pair) const;
  std::int64_t stop_of(std::uint32_t pair) const { return scene_->robot().pairs[pair].stop; }

  const NearScene* scene_;
  std::vector<Pose> poses_;
  mutable std::vector<NearBounds> bounds_;
};

/// A move there and back: the first and the last period are at the place itself.
class NearMove {
 public:
  NearMove(const NearScene& scene, std::vector<NearMoment> moments)
      : scene_(scene), moments_(std::move(moments)), distances_(moments_.size()) {}

  std::size_t size() const { return moments_.size(); }
  const NearMoment& operator[](std::size_t i) const { return moments_[i]; }
  const NearDistances& distances(std::size_t i) const;

 private:
  const NearScene& scene_;
  std::vector<NearMoment> moments_;
  mutable std::vector<std::optional<NearDistances>> distances_;
};

class NearMoves {
 public:
  NearMoves(const NearScene& scene, const NearOptions& options, Random& random);
  /// False if `tries` tries find no place.
  bool find_place(int tries = 4000);
  const NearMoment& place() const { return place_; }
  NearMove move();

 private:
  const RobotJoint& joint_of(std::size_t variable) const { return *joints_[variable]; }
  /// The variable's unit in radians or metres.
  double unit_of(std::size_t variable) const;
  JointCoordinate kept(std::size_t variable, double value) const;
  NearMoment any() const;
  /// A moment nearer to all joints at 0, for legs that nearly always touch.
  NearMoment nearer_rest() const;
  /// Finds the pairs that are near at most places; they make no place.
  void find_always_near();
  /// The least excess of the other pairs, in metres.
  double excess_at(const NearMoment& moment) const;
  /// Bisects between a place too far from contact and one too near.
  bool narrow(NearMoment far, const NearMoment& near);

  const NearScene& scene_;
  NearOptions options_;
  Random& random_;
  double cell_;
  std::vector<const RobotJoint*> joints_;
  std::vector<bool> is_always_near_;
  NearMoment place_;
};

}  // namespace flashbvh::test
