// Guards near contact: small moves about places where links are 1 to 8 mm over their stop distance,
// there and back, with and without an obstacle that moves. Each verdict is checked by the distances
// of all pairs where a period begins and ends.
//
// FLASHBVH_ROBOTS: images of `flashbvh robot --format image`, which are guarded too; prints a row
// for each robot and budget. FLASHBVH_PERIODS: periods of each.
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

#include "flashbvh/robot/workcell.hpp"
#include "robot/baked/robot_file.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

// In metres: the obstacle's edge, distances, and the excess of a place over a stop distance.
constexpr double kSide = 0.06;
constexpr double kObstacleStop = 0.005;
constexpr double kObstacleWarn = 0.01;
constexpr double kNearest = 0.001;
constexpr double kFarthest = 0.008;
/// The largest turn of a joint in a move, in radians; a fifth of it in metres for one that slides.
constexpr double kReach = 0.05;
constexpr double kSpeeds[] = {1.25e-3, 5e-3, 2e-4};  // radians a period
/// Arms made of boxes have few triangles: the first two are too small in some periods.
constexpr std::uint32_t kBudgets[] = {10, 100, 500, 2000, UINT32_MAX - 1};

double between(double from, double to, double part) {
  return from + (to - from) * part;
}

/// Joint values and the obstacle's place at one moment.
struct Moment {
  Values values;
  Frame obstacle = kIdentityFrame;
};

Moment between(const Moment& from, const Moment& to, double part) {
  const auto rounded = [part](std::int32_t u, std::int32_t v) {
    return static_cast<std::int32_t>(std::llround(between(u, v, part)));
  };
  Moment made = from;
  for (std::size_t i = 0; i < made.values.size(); ++i) {
    made.values[i] = rounded(from.values[i], to.values[i]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    made.obstacle.translation[axis] =
        rounded(from.obstacle.translation[axis], to.obstacle.translation[axis]);
  }
  return made;
}

/// A robot, optionally an obstacle, and moves of both near contact.
class Scene {
 public:
  Scene(const Robot& robot, bool has_obstacle, double turn, Random& random)
      : cell_(cell_of(robot)),
        turn_(turn),
        random_(random),
        memory_(new WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>),
        workcell_(robot, *memory_),
        joints_(robot.variable_count) {
    for (std::uint32_t i = robot.joint_count; i-- != 0;) {
      const RobotJoint& joint = robot.joints[i];
      if (joint.type != JointType::fixed && joint.shift == 0) {
        joints_[joint.variable] = &joint;
      }
    }
    if (has_obstacle) {
      add_obstacle();
    }
    find_always_near();
  }

  const Robot& robot() const { return workcell_.robot(); }
  std::uint32_t fine(double metres) const {
    return static_cast<std::uint32_t>(metres / cell_ * 256);
  }

  /// Moves the obstacle from its place at a moment to that at another one.
  void move(const Moment& from, const Moment& to) {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      squared +=
          std::pow(double(to.obstacle.translation[axis]) - from.obstacle.translation[axis], 2);
    }
    const auto moved = static_cast<std::uint32_t>(std::sqrt(squared) / kFrameCell * 256) + 1;
    if (obstacle_ != kMaxLinks) {
      (void)workcell_.move(obstacle_, to.obstacle, {moved});
    }
  }

  /// Whether a pair is within a distance, in 1/256 cell, as the guard places it.
  bool is_within(const RobotPair& of, const Moment& moment, std::uint32_t limit) const {
    PlacedLinks links(robot(), coordinates_of(robot(), moment.values));
    if (obstacle_ != kMaxLinks) {
      links.frames.back() = moment.obstacle;
    }
    return closer_than(robot().meshes[of.a], robot().meshes[of.b], links.pose(of.a, of.b),
                       {std::min(limit, kMaxGuardDistance)})
        .yes;
  }
  /// Whether all pairs exceed their stop distances, in 1/256 cell.
  bool are_over(const Moment& moment, std::uint32_t excess) const {
    bool are = true;
    for (std::uint32_t i = 0; are && i < robot().pair_count; ++i) {
      const bool is_ignored = !is_always_near_.empty() && is_always_near_[i];
      are = !is_within(robot().pairs[i], moment, robot().pairs[i].stop + (is_ignored ? 0 : excess));
    }
    return are;
  }

  /// Bisects between a moment too far from contact and one too near. False if none is found.
  bool find_place(Moment& place) const {
    Moment far;
    Moment wrong;
    for (int i = 0; i < 1000; ++i) {
      const Moment moment = any();
      (are_over(moment, fine(kFarthest)) ? far : wrong) = moment;
      for (int cut = 0; cut < 30 && !far.values.empty() && !wrong.values.empty(); ++cut) {
        place = between(far, wrong, 0.5);
        const bool is_far = are_over(place, fine(kFarthest));
        if (!is_far && are_over(place, fine(kNearest))) {
          return true;
        }
        (is_far ? far : wrong) = place;
      }
    }
    return false;
  }

  /// A move there and back: the first and the last moment are the place itself.
  std::vector<Moment> any_move(const Moment& place) const {
    Moment to = place;
    double periods = 20;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const double unit = unit_of_coordinate(joints_[i]->type, cell_);
      const double part = joints_[i]->type == JointType::prismatic ? 0.2 : 1;
      const double way = real_between(random_, -kReach, kReach) * part / unit;
      to.values[i] = random_.below(2) == 0 ? place.values[i] : kept(i, place.values[i] + way);
      const double moved = std::abs(double(to.values[i]) - place.values[i]);
      periods = std::max(periods, moved * unit / (turn_ * part) * 1.5);
    }
    for (std::int32_t& along : to.obstacle.translation) {
      along += static_cast<std::int32_t>(real_between(random_, -0.02, 0.02) / cell_ * kFrameCell);
    }
    const int there = static_cast<int>(std::ceil(periods));
    std::vector<Moment> moments;
    for (int i = 0; i <= 2 * there; ++i) {
      const double x = double(i <= there ? i : 2 * there - i) / there;
      moments.push_back(between(place, to, x * x * (3 - 2 * x)));
    }
    return moments;
  }

 private:
  void add_obstacle() {
    const double half = kSide / 2;
    Model model;
    add_link(model, kNoJoint, box({-half, -half, -half}, {half, half, half}));
    body_ = std::make_unique<BakedArm>(model, cell_);
    REQUIRE(workcell_.add(body_->meshes()[0], {kBase, kIdentityFrame}, obstacle_) == Status::done);
    for (std::uint8_t link = 0; link < obstacle_; ++link) {
      if (robot().links[link].joint != kBase) {
        REQUIRE(workcell_.keep_apart(link, obstacle_, {fine(kObstacleStop)},
                                     {fine(kObstacleWarn)}) == Status::done);
      }
    }
  }

  JointCoordinate kept(std::size_t variable, double value) const {
    const RobotJoint& joint = *joints_[variable];
    const double most = kFullTurn / 2.0 - 1;
    const bool is_free = joint.type == JointType::continuous;
    return static_cast<JointCoordinate>(
        std::clamp(value, is_free ? -most : joint.lower, is_free ? most : joint.upper));
  }

  /// Half of them nearer to all joints at 0, for legs that nearly always touch.
  Moment any() const {
    const double part = random_.below(2) == 0 ? 1 : real_between(random_, 0, 1);
    Moment made;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const double low = kept(i, -kMaxJointCoordinate);
      const double high = kept(i, kMaxJointCoordinate);
      made.values.push_back(kept(i, real_between(random_, low, high) * part));
    }
    const double far = 0.8 / cell_ * kFrameCell;
    for (std::int32_t& along : made.obstacle.translation) {
      along = static_cast<std::int32_t>(real_between(random_, -far, far));
    }
    return made;
  }

  /// Pairs that are near at most moments make no place.
  void find_always_near() {
    constexpr int kTries = 64;
    std::vector<int> near(robot().pair_count);
    for (int i = 0; i < kTries; ++i) {
      const Moment moment = any();
      for (std::uint32_t j = 0; j < robot().pair_count; ++j) {
        const RobotPair& pair = robot().pairs[j];
        near[j] += is_within(pair, moment, pair.stop + fine(kFarthest)) ? 1 : 0;
      }
    }
    for (const int count : near) {
      is_always_near_.push_back(count > kTries / 2);
    }
  }

  double cell_;
  double turn_;
  Random& random_;
  std::unique_ptr<BakedArm> body_;
  std::unique_ptr<WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>> memory_;
  Workcell workcell_;
  std::uint8_t obstacle_ = kMaxLinks;
  std::vector<const RobotJoint*> joints_;
  std::vector<bool> is_always_near_;
};

/// Numbers of periods, unless noted otherwise.
struct Counts {
  long periods = 0;
  long not_yet_known = 0;
  long warned = 0;
  long unsound = 0;  ///< a pair is nearer than the verdict or the distance states
  long stops = 0;
  long early_stops = 0;  ///< more than two periods early, on the way to contact
  long most_early = 0;
  std::uint64_t work = 0;
  std::uint32_t most_work = 0;
};

/// A guard with one budget.
class Guarded {
 public:
  Guarded(Scene& scene, std::uint32_t budget, Counts& counts)
      : scene_(scene),
        budget_(budget),
        counts_(counts),
        guard_(scene.robot(), memory_.data(), memory_.size() * sizeof memory_[0]) {}

  /// Guards a move; turns back early where the guard stops, or the place is too near.
  void run(const std::vector<Moment>& move) {
    scene_.move(move[0], move[0]);
    (void)guard_.prime(move[0].values.data());
    std::size_t at = 0;
    while (at + 1 < move.size() && !has_to_turn(move, at, at + 1)) {
      ++at;
    }
    if (at + 1 < move.size()) {
      count_stop(move, ++at);
      for (; at != 0; --at) {
        (void)has_to_turn(move, at, at - 1);
      }
    }
  }

 private:
  bool has_to_turn(const std::vector<Moment>& move, std::size_t from, std::size_t to) {
    scene_.move(move[from], move[to]);
    const GuardAnswer answer = guard_.update(move[to].values.data(), budget_);
    ++counts_.periods;
    counts_.work += answer.work;
    counts_.most_work = std::max(counts_.most_work, answer.work);
    counts_.not_yet_known += answer.verdict == Verdict::not_yet_known ? 1 : 0;
    counts_.warned += answer.verdict == Verdict::warn ? 1 : 0;
    counts_.unsound += is_sound(move[from], move[to], answer) ? 0 : 1;
    is_stopped_ = answer.verdict == Verdict::stop;
    return is_stopped_ || !scene_.are_over(move[to], 0);
  }

  bool is_sound(const Moment& before, const Moment& now, const GuardAnswer& answer) const {
    const auto holds_at = [&](const Moment& moment) {
      return holds(scene_.robot(), answer, [&](const RobotPair& pair, std::uint32_t limit) {
        return scene_.is_within(pair, moment, limit);
      });
    };
    return holds_at(before) && holds_at(now);
  }

  void count_stop(const std::vector<Moment>& move, std::size_t at) {
    if (!is_stopped_) {
      return;
    }
    ++counts_.stops;
    std::size_t contact = at;
    while (contact < move.size() && scene_.are_over(move[contact], scene_.robot().slack)) {
      ++contact;
    }
    const auto early = contact == move.size() ? 0 : static_cast<long>(contact - at);
    counts_.early_stops += early > 2 ? 1 : 0;
    counts_.most_early = std::max(counts_.most_early, early);
  }

  Scene& scene_;
  std::uint32_t budget_;
  Counts& counts_;
  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>(40'000);
  Guard guard_;
  bool is_stopped_ = false;
};

using AllCounts = std::array<Counts, std::size(kBudgets)>;

/// Guards a robot on some moves, the same with each budget.
void guard_near(const Robot& robot, Random& random, AllCounts& counts) {
  const bool has_obstacle = random.below(2) == 0;
  Scene scene(robot, has_obstacle, random.one_of(kSpeeds), random);
  Moment place;
  for (int i = 0; i < 4 && scene.find_place(place); ++i) {
    const std::vector<Moment> move = scene.any_move(place);
    for (std::size_t j = 0; j < counts.size(); ++j) {
      Guarded(scene, kBudgets[j], counts[j]).run(move);
    }
  }
}

void print(const std::string& name, const AllCounts& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Counts& of = counts[i];
    const auto periods = static_cast<double>(of.periods);
    const std::string budget = i + 1 == counts.size() ? "all" : std::to_string(kBudgets[i]);
    std::printf("| %s | %s | %ld | %.2f | %.2f | %ld | %ld | %ld | %ld | %.0f | %u |\n",
                name.c_str(), budget.c_str(), of.periods,
                100 * static_cast<double>(of.not_yet_known) / periods,
                100 * static_cast<double>(of.warned) / periods, of.stops, of.early_stops,
                of.most_early, of.unsound, static_cast<double>(of.work) / periods, of.most_work);
  }
}

/// Guards a robot, or random arms if there is none.
void check(const std::string& name, const Robot* robot) {
  const char* const robots = setting("FLASHBVH_ROBOTS");
  const long periods = number_in("FLASHBVH_PERIODS", rounds(4000L, 40'000L));
  Random random = test_random();
  AllCounts counts{};
  // Until each budget has stopped a robot, and the smallest one was too small.
  const auto lacks = [&] {
    const bool stopped =
        std::all_of(counts.begin(), counts.end(), [](const Counts& of) { return of.stops > 0; });
    return !stopped || (robot == nullptr && counts[0].not_yet_known == 0);
  };
  for (int seeds = 0; counts[0].periods < periods || (seeds < 200 && lacks()); ++seeds) {
    CAPTURE(name, seeds);
    // Else no place is near contact: bake with --pair LINK,LINK=0.
    REQUIRE((seeds < 20 || counts[0].periods != 0));
    if (robot != nullptr) {
      guard_near(*robot, random, counts);
    } else {
      guard_near(any_guarded_arm(random, 3 + random.below(3), 1e-3).robot(), random, counts);
    }
  }
  if (robots != nullptr) {
    print(name, counts);
  }
  for (const Counts& of : counts) {
    CHECK(of.unsound == 0);
  }
  CHECK_FALSE(lacks());
  CHECK(counts.back().not_yet_known == 0);
}

}  // namespace

TEST_CASE("near contact, and with an obstacle that moves, no verdict of a guard is contradicted") {
  check("generated arms", nullptr);
  const char* const robots = setting("FLASHBVH_ROBOTS");
  std::istringstream names(robots == nullptr ? "" : robots);
  for (std::string name; names >> name;) {
    const RobotFile file(name);
    check(name, &file.robot());
  }
}
