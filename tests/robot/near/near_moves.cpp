#include "near_moves.hpp"

#include <algorithm>
#include <cmath>

#include "robot/baked/fixed_robot.hpp"

namespace flashbvh::test {
namespace {

constexpr double kFine = 256;
// In metres: the obstacle's edge and distances, and the excess of a place over a stop distance.
constexpr double kSide = 0.06;
constexpr double kObstacleStop = 0.005;
constexpr double kObstacleWarn = 0.01;
constexpr double kNearest = 0.001;
constexpr double kFarthest = 0.008;
constexpr double kReach = 0.05;  // the largest turn of a joint in a move, in radians

template <class Number>
Number between(Number from, Number to, double part) {
  return static_cast<Number>(std::llround(from + (double(to) - from) * part));
}

NearMoment between(const NearMoment& from, const NearMoment& to, double part) {
  NearMoment made = from;
  for (std::size_t i = 0; i < made.values.size(); ++i) {
    made.values[i] = between(from.values[i], to.values[i], part);
  }
  for (int axis = 0; axis < 3; ++axis) {
    made.obstacle.translation[axis] =
        between(from.obstacle.translation[axis], to.obstacle.translation[axis], part);
  }
  return made;
}

std::uint32_t fine(double metres, double cell) {
  return static_cast<std::uint32_t>(metres / cell * kFine);
}

}  // namespace

NearScene::NearScene(const Robot& robot, const NearOptions& options)
    : memory_(new NearCell), workcell_(robot, *memory_) {
  if (options.has_obstacle) {
    add_obstacle();
  }
  oracle_ = std::make_unique<NearOracle>(this->robot());
}

void NearScene::add_obstacle() {
  const double cell = tool::cell_of(robot());
  const double half = kSide / 2;
  add_link(model_, tool::kNoJoint, box({-half, -half, -half}, {half, half, half}));
  body_ = std::make_unique<BakedArm>(model_, cell);
  (void)workcell_.add(body_->meshes()[0], {kBase, kIdentityFrame}, link_);
  const std::uint8_t own_links = link_;
  for (std::uint8_t link = 0; link < own_links; ++link) {
    if (robot().links[link].joint != kBase) {
      (void)workcell_.keep_apart(link, link_, {fine(kObstacleStop, cell)},
                                 {fine(kObstacleWarn, cell)});
    }
  }
}

void NearScene::move(const Frame& frame, std::uint32_t moved) {
  if (has_obstacle()) {
    (void)workcell_.move(link_, frame, {moved});
  }
}

std::vector<Pose> NearScene::poses(const NearMoment& moment) const {
  const Robot& robot = this->robot();
  const Values coordinates = coordinates_of(robot, moment.values);
  if (coordinates.empty()) {
    return {};
  }
  PlacedLinks links(robot, coordinates);
  if (has_obstacle()) {
    links.frames.back() = moment.obstacle;
  }
  std::vector<Pose> all;
  for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
    all.push_back(links.pose(robot.pairs[i].a, robot.pairs[i].b));
  }
  return all;
}

NearDistances::NearDistances(const NearScene& scene, const NearMoment& moment)
    : scene_(&scene), poses_(scene.poses(moment)) {
  for (std::uint32_t i = 0; i < poses_.size(); ++i) {
    bounds_.push_back(scene.oracle().bounds(i, poses_[i]));
  }
}

std::int64_t NearDistances::distance(std::uint32_t pair) const {
  NearBounds& bounds = bounds_[pair];
  if (bounds.lower != bounds.upper) {
    bounds = scene_->oracle().measured(pair, poses_[pair]);
  }
  return bounds.lower;
}

bool NearDistances::is_beyond(std::uint32_t pair, double limit) const {
  const NearBounds& bounds = bounds_[pair];
  return static_cast<double>(bounds.lower) > limit ||
         (static_cast<double>(bounds.upper) > limit && static_cast<double>(distance(pair)) > limit);
}

bool NearDistances::are_over(std::int64_t excess) const {
  bool are = true;
  for (std::uint32_t i = 0; are && i < bounds_.size(); ++i) {
    are = is_beyond(i, static_cast<double>(stop_of(i) + excess));
  }
  return are;
}

std::int64_t NearDistances::excess(const std::vector<bool>& is_ignored) const {
  const auto counts = [&](std::uint32_t i) {
    return !is_ignored[i] || !is_beyond(i, static_cast<double>(stop_of(i)));
  };
  // Queries only pairs that may be the nearest.
  std::int64_t most = kUnbounded;
  for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
    most = counts(i) ? std::min(most, bounds_[i].upper - stop_of(i)) : most;
  }
  std::int64_t least = kUnbounded;
  for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
    if (bounds_[i].lower - stop_of(i) <= std::min(most, least) && counts(i)) {
      least = std::min(least, distance(i) - stop_of(i));
    }
  }
  return least;
}

const NearDistances& NearMove::distances(std::size_t i) const {
  if (!distances_[i]) {
    distances_[i].emplace(scene_, moments_[i]);
  }
  return *distances_[i];
}

NearMoves::NearMoves(const NearScene& scene, const NearOptions& options, Random& random)
    : scene_(scene), options_(options), random_(random), cell_(tool::cell_of(scene.robot())) {
  const Robot& robot = scene.robot();
  joints_.resize(robot.variable_count);
  for (std::uint32_t i = robot.joint_count; i-- != 0;) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.type != JointType::fixed && joint.shift == 0) {
      joints_[joint.variable] = &joint;
    }
  }
  find_always_near();
}

double NearMoves::unit_of(std::size_t variable) const {
  return tool::unit_of_coordinate(joint_of(variable).type, cell_);
}

JointCoordinate NearMoves::kept(std::size_t variable, double value) const {
  const RobotJoint& joint = joint_of(variable);
  const double most = kFullTurn / 2.0 - 1;
  const bool is_free = joint.type == JointType::continuous;
  return static_cast<JointCoordinate>(
      std::clamp(value, is_free ? -most : joint.lower, is_free ? most : joint.upper));
}

NearMoment NearMoves::any() const {
  NearMoment made;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const double low = kept(i, -kMaxJointCoordinate);
    made.values.push_back(kept(i, real_between(random_, low, kept(i, kMaxJointCoordinate))));
  }
  const double far = 0.8 / cell_ * kFrameCell;
  for (std::int32_t& along : made.obstacle.translation) {
    along = static_cast<std::int32_t>(real_between(random_, -far, far));
  }
  return made;
}

double NearMoves::excess_at(const NearMoment& moment) const {
  const std::int64_t least = NearDistances(scene_, moment).excess(is_always_near_);
  return static_cast<double>(least) / kFine * cell_;
}

void NearMoves::find_always_near() {
  constexpr int kTries = 64;
  const Robot& robot = scene_.robot();
  std::vector<int> near(robot.pair_count);
  for (int i = 0; i < kTries; ++i) {
    const NearDistances all(scene_, any());
    for (std::uint32_t j = 0; j < robot.pair_count; ++j) {
      const double farthest = robot.pairs[j].stop + fine(kFarthest, cell_);
      near[j] += all.is_beyond(j, farthest - 1) ? 0 : 1;
    }
  }
  for (const int count : near) {
    is_always_near_.push_back(count > kTries / 2);
  }
}

bool NearMoves::narrow(NearMoment far, const NearMoment& near) {
  NearMoment wrong = near;
  for (int i = 0; i < 30; ++i) {
    const NearMoment middle = between(far, wrong, 0.5);
    const double excess = excess_at(middle);
    if (excess > kNearest && excess < kFarthest) {
      place_ = middle;
      return true;
    }
    (excess < kNearest ? wrong : far) = middle;
  }
  return false;
}

NearMoment NearMoves::nearer_rest() const {
  NearMoment rest = any();
  const NearMoment to = rest;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    rest.values[i] = kept(i, 0);
  }
  return between(rest, to, real_between(random_, 0, 1));
}

bool NearMoves::find_place(int tries) {
  std::optional<NearMoment> far;
  for (int i = 0; i < tries; ++i) {
    const NearMoment moment = far || i < tries / 2 ? any() : nearer_rest();
    if (excess_at(moment) > kFarthest) {
      far = moment;
    } else if (far && narrow(*far, moment)) {
      return true;
    }
  }
  return false;
}

NearMove NearMoves::move() {
  NearMoment to = place_;
  double periods = 2;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const bool slides = joint_of(i).type == JointType::prismatic;
    const double most = slides ? kReach * 0.2 : kReach;
    const double way = real_between(random_, -most, most) / unit_of(i);
    to.values[i] = kept(i, place_.values[i] + way);
    const double speed = (slides ? options_.slide : options_.turn) / unit_of(i);
    periods = std::max(periods, std::abs(double(to.values[i]) - place_.values[i]) / speed * 1.5);
  }
  double squared = 0;
  for (std::int32_t& along : to.obstacle.translation) {
    const double way = real_between(random_, -0.02, 0.02);
    along += static_cast<std::int32_t>(way / cell_ * kFrameCell);
    squared += way * way;
  }
  periods = scene_.has_obstacle() ? std::max(periods, std::sqrt(squared) / options_.slide * 1.5)
                                  : periods;
  const int there = static_cast<int>(std::ceil(periods));
  std::vector<NearMoment> moments;
  for (int i = 0; i <= 2 * there; ++i) {
    const double x = double(i <= there ? i : 2 * there - i) / there;
    moments.push_back(between(place_, to, x * x * (3 - 2 * x)));
  }
  return {scene_, std::move(moments)};
}

}  // namespace flashbvh::test
