// The guard against a formula: corners of a link before a wide wall, drawn between the lattice's
// points. Rounding to the lattice exceeds the doubles' error by far, so no margin hides a mistake.
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCell = 0.01;

/// The wall's place; rounding moves it by almost half a cell.
constexpr double kWall = 1.0054;

/// An arm before a wall.
FixedArm with_wall(Model model, const bake::SourceMesh& tip, double stop, double warn) {
  add_link(model, kNoJoint, box({kWall, -4, -4}, {1.5, 4, 4}));
  add_link(model, model.joints.size() - 1, tip);
  return FixedArm(model, kCell, {{0, 1, stop, warn}});
}

/// The distance of the link's corners, as drawn, to the wall, in 1/256 cell.
double true_distance(const FixedArm& arm, const Values& values) {
  const Transform frame = frames_of(arm.model, arm.variables(values)).back();
  double nearest = 1e9;
  for (const Vector3& vertex : arm.model.links[1].mesh.vertices) {
    nearest = std::min(nearest, kWall - placed(frame, vertex)[0]);
  }
  return nearest / kCell * 256;
}

struct Walk {
  explicit Walk(const FixedArm& of)
      : arm(of), state(std::make_unique<AnyGuardState>()), guard(of.robot(), *state) {}

  void prime(const Values& values) {
    before = values;
    answer = guard.prime(values.data());
  }
  /// True if each verdict holds during the whole period.
  bool holds(const Values& now, std::uint32_t work, Random& random) {
    answer = guard.update(now.data(), work);
    const Period period(arm, before, now);
    before = now;
    double nearest = 1e9;
    for (int moment = 0; moment < 8; ++moment) {
      nearest = std::min(nearest, true_distance(arm, period.at(moment, random)));
    }
    const double wanted = answer.verdict == Verdict::free   ? arm.robot().pairs[0].warn
                          : answer.verdict == Verdict::warn ? arm.robot().pairs[0].stop
                                                            : -1e9;
    return answer.status == Status::done && nearest > wanted &&
           (answer.distance == 0 || nearest >= answer.distance);
  }

  const FixedArm& arm;
  std::unique_ptr<AnyGuardState> state;
  Guard guard;
  Values before;
  GuardAnswer answer{};
};

/// Sliders that all move towards the wall.
FixedArm sliders(std::size_t count, double stop, double warn) {
  Model model;
  for (std::size_t i = 0; i < count; ++i) {
    const Transform fixed = i == 0 ? turned(1, kPi / 2) : Transform();
    add_joint(model, i == 0 ? kNoJoint : i - 1, fixed, JointType::prismatic, -0.4, 0.4);
  }
  return with_wall(model, box({-0.2, -0.2, -0.3}, {0.2043, 0.2046, 0.0048}), stop, warn);
}

/// A long rod that turns towards the wall: the joint's reach is its whole length.
FixedArm hammer(double stop, double warn) {
  Model model;
  add_joint(model, kNoJoint, composed(shifted({0.7, -2, 0}), turned(2, kPi / 2)),
            JointType::revolute, -0.3, 1.5);
  return with_wall(model, box({0.5, -0.0347, -0.1}, {2.5049, 0.0344, 0.1048}), stop, warn);
}

/// A block that turns about all axes and slides.
FixedArm tumbler(double stop, double warn) {
  Model model;
  add_joint(model, kNoJoint, composed(shifted({0.3, 0, 0}), turned(1, kPi / 2)),
            JointType::prismatic, -0.5, 0.5);
  add_joint(model, 0, turned(0, 1.2), JointType::continuous, -kPi, kPi);
  add_joint(model, 1, turned(1, 1), JointType::continuous, -kPi, kPi);
  return with_wall(model, box({-0.1048, -0.2046, -0.1747}, {0.1549, 0.1043, 0.2047}), stop, warn);
}

/// A distance that is no whole number of cells.
double any_distance(Random& random) {
  return real_between(random, 0, 4) * kCell;
}

std::vector<std::unique_ptr<FixedArm>> all_arms(Random& random) {
  std::vector<std::unique_ptr<FixedArm>> arms;
  for (int i = 0; i < 4; ++i) {
    const double stop = any_distance(random);
    const double warn = stop + any_distance(random);
    for (const std::size_t count : {1u, 2u, 3u}) {
      arms.emplace_back(new FixedArm(sliders(count, stop, warn)));
    }
    arms.emplace_back(new FixedArm(hammer(stop, warn)));
    arms.emplace_back(new FixedArm(tumbler(stop, warn)));
  }
  return arms;
}

/// Walks from random values, checked in each period.
void check_walks(Random& random, const FixedArm& arm, double speed, std::uint32_t work) {
  Walk walk(arm);
  walk.prime(arm.any_values(random));
  Wandering wandering(arm, walk.before, speed);
  for (int i = 0; i < 120; ++i) {
    CAPTURE(i, walk.answer.distance);
    REQUIRE(walk.holds(wandering.step(random), work, random));
  }
}

}  // namespace

TEST_CASE("to less than a cell: nothing reported is better than the truth") {
  Random random = test_random();
  const auto arms = all_arms(random);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      CAPTURE(round, i);
      const double speeds[] = {2e-4, 2e-3, 0.02, 0.2};
      const double speed = random.one_of(speeds);
      const std::uint32_t work = random.below(3) == 0 ? 1 + random.below(100) : UINT32_MAX;
      check_walks(random, *arms[i], speed, work);
    }
  }
}

TEST_CASE("from anywhere straight towards the wall, until all that was known is used up") {
  Random random = test_random();
  const auto arms = all_arms(random);
  for (int round = 0; round < 150; ++round) {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const FixedArm& arm = *arms[i];
      Walk walk(arm);
      walk.prime(arm.any_values(random));
      const double share = real_between(random, 0.7, 1.0);
      CAPTURE(round, i, walk.answer.distance, share);
      // The hammer's tip turns towards the wall, 2.5 from its axis.
      Values now = walk.before;
      const double way = share * walk.answer.distance / 256 * kCell;
      const RobotJoint& joint = arm.joint_of(0);
      const double turn = joint.type == JointType::revolute ? -way / 2.5 : way;
      const double to = now[0] + turn / arm.unit_of(0);
      now[0] = static_cast<JointCoordinate>(std::clamp<double>(to, joint.lower, joint.upper));
      REQUIRE(walk.holds(now, 0, random));
    }
  }
}

TEST_CASE("a joint that lags while another leads: their ways add up") {
  const FixedArm arm = sliders(2, 0.013, 0.013);
  for_rounds(400, [&](Random& random, int round) {
    Walk walk(arm);
    const JointCoordinate at = random.between(-60 * kFrameCell / 2, 0);
    walk.prime({at, at});
    const auto way = static_cast<JointCoordinate>(
        walk.answer.distance * real_between(random, 0.4, 1.1) * kFrameCell / 256);
    const JointCoordinate to = std::min(at + way, arm.joint_of(0).upper);
    CAPTURE(round, at, to);
    REQUIRE(walk.holds({to, at}, 0, random));
    REQUIRE(walk.holds({at, to}, 0, random));
    REQUIRE(walk.holds({to, at}, UINT32_MAX, random));
  });
}

TEST_CASE("at the stop and the warn distance itself, not beyond them") {
  for (const bool stops : {false, true}) {
    const double warn = 60 * kCell;
    const FixedArm arm = sliders(1, stops ? warn : 0.05, warn);
    Walk walk(arm);
    const RobotPair& pair = arm.robot().pairs[0];
    Values values = {30 * kFrameCell};
    walk.prime(values);
    REQUIRE(walk.answer.verdict == Verdict::free);
    // At 1/256 cell per period, unmeasured, the reported distance decreases by one each time.
    while (walk.answer.distance >= pair.warn) {
      values[0] += kFrameCell / 256;
      walk.answer = walk.guard.update(values.data(), 0);
      CAPTURE(walk.answer.distance, pair.stop, pair.warn);
      CHECK((walk.answer.verdict == Verdict::free) == (walk.answer.distance > pair.warn));
      CHECK((walk.answer.verdict <= Verdict::warn) == (walk.answer.distance > pair.stop));
      REQUIRE(walk.answer.distance + 1 >= pair.warn);  // no value is skipped
    }
  }
}

TEST_CASE("a joint without limits turns on and on: no certificate runs out at half a turn") {
  Model model;
  add_joint(model, kNoJoint, {}, JointType::continuous, -kPi, kPi);
  const FixedArm arm = with_wall(model, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}), 0.05, 0.1);
  Walk walk(arm);
  const Values start = {kFullTurn / 2 - 1000};
  REQUIRE(walk.guard.prime(start.data()).verdict == Verdict::free);
  for (int i = 1; i < 20; ++i) {
    const Values now = {kFullTurn / 2 - 1000 + i * 100};
    CHECK(walk.guard.update(now.data(), 0).verdict == Verdict::free);
  }
  // A third of a turn each period, starting half a turn away.
  for (int i = 1; i < 20; ++i) {
    const Values now = {
        static_cast<JointCoordinate>(kFullTurn / 2 + 900 + i * (kFullTurn / 3) % kFullTurn)};
    CHECK(walk.guard.update(now.data(), UINT32_MAX).verdict == Verdict::free);
  }
}

TEST_CASE("a pair that has nothing left does not wait for one that has") {
  Model model;
  const Transform forwards = turned(1, kPi / 2);
  add_link(model, kNoJoint, box({1, -4, -4}, {1.5, 4, 4}));
  for (const double y : {-1.0, 1.0}) {
    const Transform fixed = composed(shifted({0, y, 0}), forwards);
    const std::size_t slider = add_joint(model, kNoJoint, fixed, JointType::prismatic, -2, 0.9);
    add_link(model, slider, prism(24, 0.2, 0, 0, -0.3, 0));
  }
  const FixedArm arm(model, kCell, {{0, 1, 0.05, 0.05}, {0, 2, 0.05, 0.05}});
  Walk walk(arm);
  Values values = {0, 0};
  (void)walk.guard.prime(values.data());
  for (int i = 0; i < 80 && walk.state->core.walked_pair != 0; ++i) {
    values[0] += kFrameCell;
    (void)walk.guard.update(values.data(), 1);
  }
  REQUIRE(walk.state->core.walked_pair == 0);
  values[1] = 80 * kFrameCell;
  (void)walk.guard.update(values.data(), 1);
  CHECK(walk.state->core.walked_pair != 0);
}
