// Guard::limit(): no pair of random arms gets nearer than its floor allows, and too little work
// slows them. That arms come out: way_out_test.
#include <cstring>

#include "support/arms/any_workcell.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr std::uint32_t kBudgets[] = {5, 100, 700, UINT32_MAX};

/// A pair's distance by exact kinematics, in 1/256 cell.
std::uint32_t distance_of(const FixedArm& arm, const RobotPair& pair, const Values& values) {
  const Mesh& a = arm.robot().meshes[pair.a];
  const Mesh& b = arm.robot().meshes[pair.b];
  return distance(a, b, arm.exact_pose(pair, values)).lower;
}

/// What limit() promises of a pair, worked out here: the largest distance where it was sent, at
/// most a tenth more than its stop distance, less that tenth.
class Promise {
 public:
  Promise(const FixedArm& arm, std::uint32_t pair) : arm_(arm), pair_(arm.robot().pairs[pair]) {
    double most = 0;
    for (std::uint32_t i = 0; i < arm.robot().link_count; ++i) {
      most = std::max<double>(most, arm.robot().links[i].deviation);
    }
    const double rounding = arm.robot().slack - 2 * most;
    give_ = std::max(pair_.stop / 10.0, 8 * rounding);
    cap_ = pair_.stop + arm.robot().slack + give_;
    rounding_ = rounding + kPlacingFine;
    deviation_ = arm.robot().links[pair_.a].deviation + arm.robot().links[pair_.b].deviation;
  }

  void see(const Values& values) {
    const double seen = distance_of(arm_, pair_, values);
    largest_ = std::min(cap_, std::max(largest_, seen));
  }
  /// Whether the guard's floor is what was seen; it is measured to a 32nd, or to half a tenth.
  bool is_seen(std::uint32_t floor) const {
    return floor + 2 >= largest_ - largest_ / 32 - give_ / 2 - rounding_ &&
           floor <= largest_ + rounding_;
  }
  bool holds(const DrawnArm& drawn, const Values& values, std::uint32_t floor) const {
    const double kept = floor - std::min(give_, floor / 2.0) - deviation_;
    return kept <= 0 || !drawn.is_closer(pair_, values, static_cast<std::uint32_t>(kept));
  }
  /// Whether update() may permit leaving, by a floor that it measured.
  bool may_leave(const DrawnArm& drawn, const Values& values, std::uint32_t floor) const {
    return !drawn.is_closer(pair_, values, pair_.stop) || holds(drawn, values, floor);
  }
  double cap() const { return cap_; }

 private:
  const FixedArm& arm_;
  const RobotPair& pair_;
  double give_;
  double cap_;
  double rounding_;
  double deviation_;
  double largest_ = 0;
};

/// Whether the answer names the pair that lets no more through.
bool names_pair(const LimitAnswer& answer, const FixedArm& arm) {
  return answer.pair < arm.robot().pair_count ||
         (answer.verdict != LimitVerdict::shortened && answer.verdict != LimitVerdict::held);
}

/// Commands to one arm, each judged.
struct Commanded {
  Commanded(const FixedArm& of, const Values& at)
      : arm(of), drawn(of), state(std::make_unique<AnyGuardState>()), guard(of.robot(), *state) {
    for (std::uint32_t i = 0; i < arm.robot().pair_count; ++i) {
      promises.emplace_back(arm, i);
    }
    start(at);
  }

  void start(const Values& at) {
    (void)guard.prime(at.data());
    now = measured = at;
    for (Promise& promise : promises) {
      promise.see(at);
    }
  }

  LimitAnswer command(const Values& wanted, std::uint32_t work, Random& random) {
    Values granted(wanted.size());
    std::vector<std::uint32_t> floors;
    for (std::uint16_t i = 0; i < promises.size(); ++i) {
      floors.push_back(guard.floor(i));
    }
    const LimitAnswer answer = guard.limit(wanted.data(), granted.data(), work);
    REQUIRE(answer.status == Status::done);
    REQUIRE(names_pair(answer, arm));
    const Period period(arm, now, granted);
    now = period.at_end();
    for (std::uint16_t i = 0; i < promises.size(); ++i) {
      CAPTURE(i, work, static_cast<int>(answer.verdict), answer.share, floors[i], guard.floor(i));
      for (int moment = 0; moment < 4; ++moment) {
        REQUIRE(promises[i].holds(drawn, period.at(moment, random), floors[i]));
      }
      promises[i].see(now);
      REQUIRE((answer.share == 0 || promises[i].is_seen(guard.floor(i))));
    }
    return answer;
  }

  /// The robot follows what was granted, each joint at its own pace. Returns update()'s verdict.
  Verdict follow(std::uint32_t work, Random& random) {
    std::vector<std::uint32_t> floors;
    for (std::uint16_t i = 0; i < promises.size(); ++i) {
      const GuardPair& pair = state->pairs[i];
      const std::uint32_t own = (pair.seen & kOwn) != 0 ? pair.lower : 0;
      floors.push_back(std::max(pair.seen & ~kOwn, std::min(own, kMaxGuardDistance)));
      floors.back() = std::min(floors.back(), static_cast<std::uint32_t>(promises[i].cap()));
    }
    const Values next = Period(arm, measured, now).between(random);
    const GuardAnswer answer = guard.update(next.data(), work);
    REQUIRE(answer.status == Status::done);
    const Period period(arm, measured, next);
    measured = period.at_end();
    for (std::uint16_t i = 0; answer.verdict <= Verdict::leaving && i < promises.size(); ++i) {
      CAPTURE(i, work, floors[i]);
      for (int moment = 0; moment < 4; ++moment) {
        REQUIRE(promises[i].may_leave(drawn, period.at(moment, random), floors[i]));
      }
    }
    return answer.verdict;
  }

  const FixedArm& arm;
  DrawnArm drawn;
  std::unique_ptr<AnyGuardState> state;
  Guard guard;
  std::vector<Promise> promises;
  Values now;
  Values measured;
};

/// A step from some values towards others.
Values step_towards(const FixedArm& arm, const Values& from, const Values& to, double speed) {
  Values next;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double most =
        speed *
        (arm.is_free(i) ? kFullTurn : double(arm.joint_of(i).upper) - arm.joint_of(i).lower);
    const std::int32_t way = Period(arm, from, to).at_end()[i] - from[i];
    next.push_back(from[i] + static_cast<std::int32_t>(std::clamp<double>(way, -most, most)));
  }
  return next;
}

}  // namespace

TEST_CASE("limit: no command brings a pair nearer than its floor allows, whatever the budget") {
  const long commands = number_in("FLASHBVH_COMMANDS", rounds(3000L, 20'000L));
  long moved = 0;
  long left = 0;
  for_rounds(static_cast<int>(commands / 150), [&](Random& random, int) {
    const FixedArm arm(any_guarded_arm(random, 3 + random.below(3), 2e-3));
    Commanded commanded(arm, arm.any_values(random));
    const std::uint32_t work = random.one_of(kBudgets);
    const double speeds[] = {1e-3, 1e-2, 0.1};
    const double speed = random.one_of(speeds);
    Values target = arm.any_values(random);
    for (int i = 0; i < 150; ++i) {
      target = random.below(20) == 0 ? arm.any_values(random) : target;
      const Values wanted = step_towards(arm, commanded.now, target, speed);
      moved += commanded.command(wanted, work, random).share != 0 ? 1 : 0;
      left += commanded.follow(work, random) == Verdict::leaving ? 1 : 0;
    }
  });
  CHECK(moved > commands / 10);  // an arm whose links touch stands still
  CHECK(left > 0);
}

TEST_CASE("limit: an arm with little work gets where it gets with all, or is held by a pair") {
  int arrived = 0;
  for_rounds(rounds(40, 2000), [&](Random& random, int) {
    const FixedArm arm(any_guarded_arm(random, 3 + random.below(3), 2e-3));
    const Values begin = arm.any_values(random);
    const double speeds[] = {1e-3, 3e-3, 1e-2};
    const double speed = random.one_of(speeds);
    int since_held = 1000;
    const auto go_to = [&](const Values& target, std::uint32_t work, int commands) {
      const auto state = std::make_unique<AnyGuardState>();
      Guard guard(arm.robot(), *state);
      (void)guard.prime(begin.data());
      Values now = begin;
      for (int i = 0; i < commands && now != Period(arm, now, target).at_end(); ++i) {
        Values granted(now.size());
        const Values wanted = step_towards(arm, now, target, speed);
        const LimitAnswer answer = guard.limit(wanted.data(), granted.data(), work);
        const LimitVerdict verdict = answer.verdict;
        REQUIRE(names_pair(answer, arm));
        since_held = verdict == LimitVerdict::held ? 0 : since_held + 1;
        if (work == UINT32_MAX && verdict != LimitVerdict::granted) {
          break;
        }
        now = Period(arm, now, granted).at_end();
        (void)guard.update(now.data(), work);
      }
      return now;
    };
    const Values end = go_to(arm.any_values(random), UINT32_MAX, 400);
    const std::uint32_t works[] = {5, 20, 60, 200, 500};
    const Values at = go_to(end, random.one_of(works), 5000);
    const bool arrives = at == Period(arm, at, end).at_end();
    CHECK((arrives || since_held < 200));
    arrived += arrives && begin != end ? 1 : 0;
  });
  CHECK(arrived > 10);
}

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
