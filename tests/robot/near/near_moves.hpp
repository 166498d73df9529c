// Small moves about places where an arm's links nearly touch, as a welding or assembly arm works,
// and how far apart all guarded pairs are on the way.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "flashbvh/robot/workcell.hpp"
#include "near_distances.hpp"
#include "support/arms/arms.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

/// Lengths in metres, speeds per period.
struct NearOptions {
  double turn = 1.25e-3;      ///< top speed of turning joints, in radians
  double slide = 5e-4;        ///< of sliding joints and of the obstacle
  double nearest = 0.001;     ///< a place is so far over a stop distance at least,
  double farthest = 0.008;    ///< and at most
  double reach = 0.05;        ///< radians that a move turns a joint at most
  bool has_obstacle = false;  ///< that moves, at most 70 mm over the stop distance
  double obstacle_stop = 0.005;
  double obstacle_warn = 0.01;
};

using NearValues = std::vector<JointCoordinate>;
using NearCell = WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>;

/// What one moment holds.
struct NearMoment {
  NearValues values;
  Frame obstacle = kIdentityFrame;
};

/// A robot, and maybe an obstacle: what a guard takes.
class NearScene {
 public:
  NearScene(const Robot& robot, const NearOptions& options);
  const Robot& robot() const { return workcell_.robot(); }
  bool has_obstacle() const { return link_ != kMaxLinks; }
  /// Moves the obstacle there, by at most `moved`, in 1/256 cell.
  void move(const Frame& frame, std::uint32_t moved);
  /// Of all pairs: B in A's frame, as the guard places it.
  std::vector<Pose> poses(const NearMoment& moment) const;
  NearOracle& oracle() const { return *oracle_; }

 private:
  void add_obstacle(const NearOptions& options);

  std::unique_ptr<BakedArm> body_;
  tool::Model model_;
  std::unique_ptr<NearCell> memory_;
  Workcell workcell_;
  std::uint8_t link_ = kMaxLinks;
  std::unique_ptr<NearOracle> oracle_;
};

/// Of all pairs at a moment, in 1/256 cell, rounded down; of the placed meshes.
class NearDistances {
 public:
  NearDistances(const NearScene& scene, const NearMoment& moment);

  bool is_beyond(std::uint32_t pair, double limit) const;
  /// Whether all are farther over their stop distances.
  bool are_over(std::int64_t excess) const;
  /// How far over the stop distance the nearest pair is; may be negative. `counts(pair)`: whether
  /// the pair does.
  template <class Counts>
  std::int64_t excess(const Counts& counts) const {
    std::int64_t most = INT64_MAX;
    for_each_excess([&](std::uint32_t i, std::int64_t /*lower*/, std::int64_t upper) {
      most = counts(i) ? std::min(most, upper) : most;
    });
    std::int64_t least = INT64_MAX;
    for_each_excess([&](std::uint32_t i, std::int64_t lower, std::int64_t /*upper*/) {
      if (lower <= most && lower < least && counts(i)) {
        least = std::min(least, distance(i) - stop_of(i));
      }
    });
    return least;
  }

 private:
  std::int64_t distance(std::uint32_t pair) const;
  std::int64_t stop_of(std::uint32_t pair) const { return scene_->robot().pairs[pair].stop; }
  template <class Visit>
  void for_each_excess(const Visit& visit) const {
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
      const std::int64_t upper = bounds_[i].upper;
      visit(i, bounds_[i].lower - stop_of(i), upper == INT64_MAX ? upper : upper - stop_of(i));
    }
  }

  const NearScene* scene_;
  std::vector<Pose> poses_;
  mutable std::vector<NearBounds> bounds_;
};

/// There and back: period 0 and the last one are at the place itself.
class NearMove {
 public:
  NearMove(const NearScene& scene, std::vector<NearMoment> moments)
      : scene_(scene), moments_(std::move(moments)), distances_(moments_.size()) {}

  std::size_t size() const { return moments_.size(); }
  const NearMoment& operator[](std::size_t i) const { return moments_[i]; }
  const NearDistances& distances(std::size_t i) const;
  /// How far over the stop distance the nearest pair is, in 1/256 cell; may be negative.
  std::int64_t excess(std::size_t i) const;

 private:
  const NearScene& scene_;
  std::vector<NearMoment> moments_;
  mutable std::vector<std::optional<NearDistances>> distances_;
};

class NearMoves {
 public:
  NearMoves(const NearScene& scene, const NearOptions& options, Random& random);
  /// False if so many tries found no place.
  bool find_place(int tries = 4000);
  const NearMoment& place() const { return place_; }
  NearMove move();

 private:
  const RobotJoint& joint_of(std::size_t variable) const { return *joints_[variable]; }
  /// A unit of the variable in radians or metres.
  double unit_of(std::size_t variable) const;
  JointCoordinate kept(std::size_t variable, double value) const;
  NearMoment any() const;
  /// Of legs that nearly always touch, on the way from where all joints stand at 0.
  NearMoment nearer_rest() const;
  /// Pairs that are near at most places do not make a place.
  void find_always_near();
  /// Of the other pairs, in metres.
  double excess_at(const NearMoment& moment) const;
  /// Halves the way from a place that is too far from contact to one that is too near.
  bool narrow(NearMoment far, const NearMoment& near);

  const NearScene& scene_;
  NearOptions options_;
  Random& random_;
  double cell_;
  std::vector<const RobotJoint*> joints_;
  std::vector<bool> is_always_near_;
  NearMoment place_;
};

double cell_of(const Robot& robot);

}  // namespace flashbvh::test
