// Guard::limit() of a block on a slide before a wall, where each answer is known.
#include <cstring>

#include "support/arms/any_workcell.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kSlideCell = 1e-4;

/// A block on a slide before a wall, which it touches at 0.6 m; it keeps 20 mm.
FixedArm slide_before_wall() {
  Model model;
  add_joint(model, kNoJoint, {}, JointType::prismatic, -0.5, 0.7);
  add_link(model, kNoJoint, box({-0.1, -0.1, 0.7}, {0.1, 0.1, 0.8}));
  add_link(model, 0, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  return FixedArm(model, kSlideCell, {{0, 1, 0.02, 0.05}});
}

struct Slide {
  FixedArm arm = slide_before_wall();
  std::unique_ptr<AnyGuardState> state = std::make_unique<AnyGuardState>();
  Guard guard{arm.robot(), *state};
  JointCoordinate at = 0;

  JointCoordinate coordinate(double metres) const {
    return static_cast<JointCoordinate>(std::lround(metres / arm.unit_of(0)));
  }
  double metres() const { return at * arm.unit_of(0); }
  void start(double metres) {
    at = coordinate(metres);
    (void)guard.prime(&at);
  }
  LimitAnswer command(double metres, std::uint32_t work = UINT32_MAX) {
    const JointCoordinate wanted = coordinate(metres);
    return guard.limit(&wanted, &at, work);
  }
};

}  // namespace

TEST_CASE("limit: a block before a wall goes to its stop distance, and from inside only away") {
  Slide slide;
  slide.start(0.3);
  CHECK(slide.command(0.35).verdict == LimitVerdict::granted);
  for (int i = 0; i < 100; ++i) {
    const LimitAnswer answer = slide.command(0.7);
    REQUIRE(answer.pair == 0);
    REQUIRE(answer.verdict != LimitVerdict::granted);
  }
  // At its stop distance and half a tenth of it, and no nearer; a cell or two are rounding.
  CHECK(slide.metres() == Approx(0.6 - 0.021).margin(0.003));
  CHECK(slide.command(0.7).verdict == LimitVerdict::held);
  CHECK(slide.command(0.56).verdict == LimitVerdict::granted);

  slide.start(0.59);  // 10 mm apart
  CHECK(slide.command(0.61).share < 4096);
  CHECK(slide.metres() < 0.5912);  // a tenth of the stop distance in all, half of it at the end
  for (const double metres : {0.58, 0.6, 0.57, 0.6, 0.56, 0.6}) {
    const double floor = slide.guard.floor(0) * kSlideCell / 256;
    (void)slide.command(metres);
    CHECK(0.6 - slide.metres() > floor - 0.002 - 0.0001);
  }
  CHECK(slide.metres() < 0.6 - 0.018);

  slide.start(0.599);  // 1 mm apart: less than a tenth of the stop distance
  for (int i = 0; i < 20; ++i) {
    (void)slide.command(0.61);
  }
  CHECK(slide.metres() < 0.5994);   // a quarter of it at the end
  for (int i = 0; i < 3000; ++i) {  // in small steps: all of a share is some motion
    const JointCoordinate before = slide.at;
    const LimitAnswer answer = slide.command(slide.metres() + (1 + i % 97) * slide.arm.unit_of(0));
    REQUIRE((answer.share == 0 || slide.at != before));
  }
  CHECK(slide.command(0.5).verdict == LimitVerdict::granted);
}

TEST_CASE("update: an arm inside its stop distance is leaving until it gets deeper than it was") {
  Slide slide;
  const auto verdict_at = [&](double metres, std::uint32_t work = UINT32_MAX) {
    const JointCoordinate at = slide.coordinate(metres);
    return slide.guard.update(&at, work).verdict;
  };
  slide.start(0.59);  // 10 mm apart; a tenth of the stop distance is 2 mm
  CHECK(verdict_at(0.59) == Verdict::leaving);
  CHECK(verdict_at(0.591) == Verdict::leaving);
  CHECK(verdict_at(0.594) == Verdict::stop);
  CHECK(verdict_at(0.59) == Verdict::stop);  // it came from there
  CHECK(verdict_at(0.59) == Verdict::leaving);
  CHECK(verdict_at(0.57) == Verdict::leaving);  // it was inside in this period
  CHECK(verdict_at(0.57) == Verdict::warn);
  CHECK(verdict_at(0.585) == Verdict::stop);  // 30 mm apart before, and never nearer than 20 again
  CHECK(verdict_at(0.585) == Verdict::stop);
  CHECK(verdict_at(0.4) == Verdict::stop);
  CHECK(verdict_at(0.4) == Verdict::free);

  slide.start(0.59);  // the drives do not follow a command: what it would reach raises no floor
  CHECK(slide.command(0.5).verdict == LimitVerdict::granted);
  CHECK(verdict_at(0.5902) == Verdict::leaving);
  CHECK(verdict_at(0.59) == Verdict::leaving);

  slide.start(0.61);  // intersects
  CHECK(verdict_at(0.61) == Verdict::stop);
  REQUIRE(slide.guard.release(0, {256}) == Status::done);
  CHECK(verdict_at(0.611) == Verdict::leaving);
  slide.at = slide.coordinate(0.61);
  while (slide.metres() > 0.5) {
    (void)slide.command(0.3);
    CHECK(verdict_at(slide.metres()) <= Verdict::leaving);
  }
  CHECK(verdict_at(0.3) == Verdict::free);
}

TEST_CASE("limit: an obstacle that comes near lowers a floor by its way, and no arm creeps in") {
  Model model;
  add_joint(model, kNoJoint, {}, JointType::prismatic, -0.5, 0.7);
  add_link(model, kNoJoint, box({-0.1, -0.1, -3.0}, {0.1, 0.1, -2.9}));
  add_link(model, 0, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, kWorkcellCell, {{0, 1, 0.02, 0.05}});
  Random random(test_seed());
  const Body body(random);
  AnyWorkcell memory;
  Workcell workcell(arm.robot(), memory);
  const double top = body.low[2];
  const auto frame_at = [&](double z) { return fixed_frame(shifted({0, 0, z - top})); };
  std::uint8_t obstacle = 0;
  REQUIRE(workcell.add(body.mesh(), {kBase, frame_at(0.5)}, obstacle) == Status::done);
  const auto fine = [](double metres) {
    return FineLength{static_cast<std::uint32_t>(metres / kWorkcellCell * 256) + 2};
  };
  REQUIRE(workcell.keep_apart(1, obstacle, fine(0.3), fine(0.35)) == Status::done);
  WorkcellState state{};
  Guard guard(workcell.robot(), state);
  JointCoordinate at = 0;
  REQUIRE(guard.prime(&at).verdict == Verdict::free);
  const double unit = arm.unit_of(0);
  double wall = 0.5;
  double came = 0;
  double least = 1;
  for (int command = 0; command < 300; ++command) {
    const double way = real_between(random, -3e-4, 3e-4);
    wall += way;
    came += std::max(0.0, -way);
    REQUIRE(workcell.move(obstacle, frame_at(wall), fine(std::abs(way))) == Status::done);
    const JointCoordinate wanted = std::min<JointCoordinate>(
        at + static_cast<JointCoordinate>(0.01 / unit), arm.robot().joints[0].upper);
    (void)guard.limit(&wanted, &at, command % 3 == 0 ? 40 : UINT32_MAX);
    least = std::min(least, wall - 0.1 - at * unit);
    REQUIRE(least > 0.3 - came);
    const JointCoordinate here = at;  // a command to stay says no more than was measured
    (void)guard.limit(&here, &at, UINT32_MAX);
    const PlacedLinks links(workcell.robot(), coordinates_of(workcell.robot(), {at}));
    const Mesh* const meshes = workcell.robot().meshes;
    REQUIRE(state.pairs[1].granted <= distance(meshes[1], meshes[2], links.pose(1, 2)).upper);
  }
  CHECK(least < 0.33);
  REQUIRE(guard.release(1, fine(0.01)) == Status::done);
  REQUIRE(workcell.move(obstacle, frame_at(wall + 1e-3), fine(1e-3)) == Status::done);
  const JointCoordinate zero = 0;
  while (at != 0) {
    const JointCoordinate before = at;
    (void)guard.limit(&zero, &at, UINT32_MAX);
    REQUIRE(at < before);
  }
}

TEST_CASE("limit: too little work slows a command and does not stop it") {
  Slide slide;
  slide.start(0.55);
  CHECK(slide.command(0.5, 0).verdict == LimitVerdict::not_yet_known);
  CHECK(slide.metres() == Approx(0.55));
  slide.start(-0.4);
  int commands = 0;
  for (; slide.metres() < 0.55 && commands < 2000; ++commands) {
    const LimitAnswer answer = slide.command(slide.metres() + 0.01, 3);
    REQUIRE(answer.status == Status::done);
    REQUIRE(answer.work < 400);
  }
  CHECK(commands < 1000);
}

TEST_CASE("limit: refused values change nothing") {
  Slide slide;
  slide.start(0.3);
  CHECK(slide.command(0.4).verdict == LimitVerdict::granted);
  const JointCoordinate before = slide.at;
  const AnyGuardState state = *slide.state;
  const JointCoordinate beyond = slide.coordinate(0.9);
  for (const JointCoordinate& wanted : {beyond, kNoCoordinate}) {
    const LimitAnswer answer = slide.guard.limit(&wanted, &slide.at, UINT32_MAX);
    CHECK(answer.verdict == LimitVerdict::refused);
    CHECK(answer.status ==
          (wanted == beyond ? Status::joint_out_of_limits : Status::not_a_coordinate));
    CHECK(slide.at == before);
  }
  CHECK(std::memcmp(state.pairs, slide.state->pairs, sizeof state.pairs) == 0);
  CHECK(state.granted[0] == slide.state->granted[0]);
  Guard fresh(slide.arm.robot(), *slide.state);
  CHECK(fresh.limit(&before, &slide.at, 1).status == Status::guard_state_invalid);
  CHECK(fresh.release(0, {1}) == Status::guard_state_invalid);
}

TEST_CASE("limit: a released pair moves slowly until it is apart, and then keeps its floor") {
  Slide slide;
  slide.start(0.62);  // 20 mm inside the wall
  CHECK(slide.command(0.5).verdict == LimitVerdict::held);
  CHECK(slide.guard.release(1, {1}) == Status::guard_state_invalid);
  CHECK(slide.guard.release(0, {kMaxGuardDistance + 1}) == Status::distance_out_of_range);
  REQUIRE(slide.guard.release(0, {2560}) == Status::done);  // 1 mm a command
  REQUIRE(slide.guard.release(0, {2560}) == Status::done);
  int commands = 0;
  for (; slide.guard.floor(0) == 0 && commands < 100; ++commands) {
    const double before = slide.metres();
    (void)slide.command(0.3, commands < 3 ? 0 : UINT32_MAX);
    REQUIRE(before - slide.metres() <= 0.001 + 1e-6);
  }
  CHECK((commands > 18 && commands < 40));
  CHECK(slide.metres() < 0.6);
  (void)slide.command(0.65);
  CHECK(slide.metres() < 0.6);
  for (int i = 0; i < 20; ++i) {
    (void)slide.command(0.3);
  }
  CHECK(slide.metres() == Approx(0.3));
}

TEST_CASE("limit: a state that is resumed keeps floors; a damaged one is refused or ends") {
  Slide slide;
  slide.start(0.59);
  (void)slide.command(0.58);
  const std::uint32_t floor = slide.guard.floor(0);
  AnyGuardState stored = *slide.state;
  Guard other(slide.arm.robot(), stored);
  stored = *slide.state;
  REQUIRE(other.resume() == Status::done);
  CHECK(other.floor(0) == floor);
  const JointCoordinate wanted = slide.coordinate(0.6);
  JointCoordinate granted = 0;
  (void)other.limit(&wanted, &granted, UINT32_MAX);
  CHECK(granted * slide.arm.unit_of(0) < 0.583);
  for_rounds(rounds(2000, 5000), [&](Random& random, int) {
    stored = *slide.state;
    const std::size_t bit = random.below(8 * sizeof stored.core);
    auto* const bytes = reinterpret_cast<unsigned char*>(
        random.below(2) == 0 ? static_cast<void*>(&stored.core) : &stored.pairs[0]);
    bytes[bit / 8 % sizeof(GuardPair)] ^= static_cast<unsigned char>(1u << bit % 8);
    if (other.resume() == Status::done) {
      REQUIRE(other.limit(&wanted, &granted, UINT32_MAX).work < 1'000'000);
    }
  });
}
