// Guards count how far obstacles moved: over rejected periods, walks, and stored states.
#include "support/arms/any_workcell.hpp"
#include "support/test.hpp"

namespace {

constexpr std::uint32_t kMostMove = (1u << 28) - 1;

/// A joint without limits with a box, and two obstacles far from it, kept apart from the box.
struct ObstacleScene {
  explicit ObstacleScene(const Body& obstacle) : arm(model(), kWorkcellCell), body(obstacle) {
    make();
  }

  static Model model() {
    Model made;
    const std::size_t joint = add_joint(made, tool::kNoJoint, {}, JointType::continuous, -kPi, kPi);
    add_link(made, joint, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
    return made;
  }
  static Frame at(double x) { return fixed_frame(shifted({x, 0, 0})); }

  /// A place where the obstacle intersects the box's wall.
  double on_wall() const { return 0.1 - body.low[0] - body.size[0] / 2; }

  /// The workcell again, as after a restart.
  void make() {
    memory = std::make_unique<AnyWorkcell>();
    workcell = std::make_unique<Workcell>(arm.robot(), *memory);
    for (std::uint8_t& link : links) {
      REQUIRE(workcell->add(body.mesh(), {kBase, at(100)}, link) == Status::done);
      const bool is_first = &link == links;
      REQUIRE(workcell->keep_apart(is_first ? 0 : link, is_first ? link : 0, {256}, {2560}) ==
              Status::done);
    }
  }
  void move(double to, std::uint32_t moved, int obstacle = 0) {
    REQUIRE(workcell->move(links[obstacle], at(to), {moved}) == Status::done);
  }
  /// Moves an obstacle in place by 2^27, so many times.
  void circle(int times, int obstacle = 0) {
    for (int i = 0; i < times; ++i) {
      move(100, 1u << 27, obstacle);
    }
  }

  FixedArm arm;
  const Body& body;
  std::unique_ptr<AnyWorkcell> memory;
  std::unique_ptr<Workcell> workcell;
  std::uint8_t links[2] = {};
};

/// A scene and a guard that has measured it.
struct PrimedScene : ObstacleScene {
  explicit PrimedScene(const Body& obstacle)
      : ObstacleScene(obstacle), guard(workcell->robot(), state) {
    REQUIRE(guard.prime(&value).verdict == Verdict::free);
  }
  GuardAnswer update(std::uint32_t work = UINT32_MAX) { return guard.update(&value, work); }
  /// Moves the first obstacle so near that a pair is walked, and stops within the walk.
  void begin_walk() {
    move(0.5, kMostMove);
    while (state.core.walked_pair == kNoPair) {
      (void)update(1);
    }
  }

  JointCoordinate value = 0;
  WorkcellState state{};
  Guard guard;
};

}  // namespace

TEST_CASE("rejected periods hide no obstacle's motion, however long") {
  Random random(test_seed());
  const Body body(random);
  for (const bool calls_guard : {false, true}) {
    CAPTURE(calls_guard);
    PrimedScene scene(body);
    const JointCoordinate rejected = kNoCoordinate;
    for (int i = 0; i < 32; ++i) {  // 2^32 in all
      scene.move(i < 31 ? 100 : scene.on_wall(), 1u << 27);
      if (calls_guard) {
        CHECK(scene.guard.update(&rejected, 1000).status == Status::not_a_coordinate);
      }
    }
    for (int i = 0; i < 2; ++i) {
      const GuardAnswer answer = scene.update();
      CHECK(answer.status == Status::joint_jumped);
      CHECK(answer.verdict == Verdict::refused);
    }
    CHECK(scene.guard.prime(&scene.value).verdict == Verdict::stop);
    scene.move(100, kMostMove);
    (void)scene.update();
    CHECK(scene.update().verdict == Verdict::free);
  }
}

TEST_CASE("a period takes each obstacle's motion of less than 2^31, and rejects more") {
  Random random(test_seed());
  const Body body(random);
  const auto status_after = [&](std::uint32_t first, int times, std::uint32_t last) {
    PrimedScene scene(body);
    scene.move(100, first);  // the count starts anywhere
    REQUIRE(scene.update().status == Status::done);
    scene.circle(times);
    scene.move(100, last);
    const GuardAnswer answer = scene.update();
    CHECK(answer.verdict > Verdict::warn);
    return answer.status;
  };
  for (const std::uint32_t first : {0u, 1u, (1u << 24) - 1, kMostMove}) {
    CAPTURE(first);
    CHECK(status_after(first, 15, 1u << 27) == Status::joint_jumped);
    CHECK(status_after(first, 24, 0) == Status::joint_jumped);
    CHECK(status_after(first, 40, 7) == Status::joint_jumped);
    CHECK(status_after(first, 15, (1u << 27) - (1u << 24)) == Status::done);
    CHECK(status_after(first, 8, 0) == Status::done);
  }
  PrimedScene scene(body);
  scene.circle(7, 0);  // together less than 2^31
  scene.circle(8, 1);
  CHECK(scene.update().status == Status::done);
}

TEST_CASE("laps count on where they wrap, and are sealed") {
  Random random(test_seed());
  const Body body(random);
  PrimedScene scene(body);
  const std::uint8_t joint = scene.memory->links[scene.links[0]].joint;
  scene.memory->joints[joint].laps = (1u << 24) - 1;
  REQUIRE(scene.guard.prime(&scene.value).verdict == Verdict::free);
  scene.guard.seal();
  CHECK(scene.guard.verify() == Status::done);
  scene.state.core.laps ^= 1u << 23;
  CHECK(scene.guard.verify() == Status::guard_state_invalid);
  scene.state.core.laps ^= 1u << 23;
  for (const std::uint32_t laps : {7u, 15u}) {  // the second period begins behind the wrap
    scene.move(100, 1u << 27);
    CHECK(scene.update().status == Status::done);
    CHECK(scene.state.core.laps == laps);
  }
  scene.circle(16);
  CHECK(scene.update().status == Status::joint_jumped);
}

TEST_CASE("no certificate outlives 2^30 of an obstacle's motion while it is measured") {
  Random random(test_seed());
  const Body body(random);
  PrimedScene scene(body);
  scene.begin_walk();
  CHECK(scene.update(0).status == Status::done);
  CHECK(scene.state.core.walked_pair != kNoPair);  // the obstacle stands still
  for (int i = 0; i < 32; ++i) {
    scene.move(i < 31 ? 100 : scene.on_wall(), 1u << 27);
    CHECK(scene.update(0).verdict > Verdict::warn);
  }
  CHECK(scene.state.core.walked_pair == kNoPair);
  CHECK(scene.guard.go_on(UINT32_MAX).verdict == Verdict::stop);
}

TEST_CASE("a stored state certifies no obstacle of a workcell that was made again") {
  Random random(test_seed());
  const Body body(random);
  for (const bool is_walked : {false, true}) {
    CAPTURE(is_walked);
    PrimedScene scene(body);
    const std::uint32_t moved = 3u << 24;
    scene.move(200, moved);
    (void)scene.update();
    REQUIRE(scene.update().verdict == Verdict::free);
    if (is_walked) {
      scene.begin_walk();
    }
    const WorkcellState stored = scene.state;
    scene.make();
    Guard guard(scene.workcell->robot(), scene.state);
    scene.state = stored;
    scene.move(scene.on_wall(), moved);
    REQUIRE(guard.resume() == Status::done);
    CHECK(scene.state.core.walked_pair == kNoPair);
    CHECK(guard.update(&scene.value, 0).verdict == Verdict::not_yet_known);
    CHECK(guard.go_on(UINT32_MAX).verdict == Verdict::stop);
    scene.move(100, kMostMove);
    (void)guard.update(&scene.value, UINT32_MAX);
    CHECK(guard.update(&scene.value, UINT32_MAX).verdict == Verdict::free);
  }
}

TEST_CASE("a stored state keeps the certificates of links and tools") {
  Random random(test_seed());
  const auto cell = std::make_unique<CrowdedCell>(random);
  const auto state = std::make_unique<WorkcellState>();
  Guard guard(cell->robot(), *state);
  Values values;
  (void)prime_apart(random, cell->arm, guard, 50, values);
  const WorkcellState stored = *state;
  REQUIRE(guard.resume() == Status::done);
  for (std::uint32_t i = 0; i < cell->robot().pair_count; ++i) {
    const RobotPair& pair = cell->robot().pairs[i];
    const bool has_obstacle = pair.b == cell->links[1] || pair.b == cell->links[2] ||
                              pair.a == cell->links[1] || pair.a == cell->links[2];
    CHECK(state->pairs[i].upper == (has_obstacle ? UINT32_MAX : stored.pairs[i].upper));
    CHECK(state->pairs[i].lower == (has_obstacle ? 0 : stored.pairs[i].lower));
  }
}
