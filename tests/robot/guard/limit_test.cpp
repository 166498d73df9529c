// Guard::limit(): no pair of random arms gets nearer than its floor allows, arms inside their stop
// distance come out, and too little work slows them.
#include <cstring>

#include "support/arms/guarded_arm.hpp"
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
    give_ = std::max(pair_.stop / 10.0, 4 * rounding);
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
  bool is_out(const Values& values) const {
    return distance_of(arm_, pair_, values) > pair_.stop + arm_.robot().slack;
  }
  bool is_touching() const { return largest_ < 4 * rounding_; }

 private:
  const FixedArm& arm_;
  const RobotPair& pair_;
  double give_;
  double cap_;
  double rounding_;
  double deviation_;
  double largest_ = 0;
};

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
    now = at;
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

  bool is_out(const Values& values) const {
    return std::all_of(promises.begin(), promises.end(),
                       [&](const Promise& of) { return of.is_out(values); });
  }
  bool is_out() const { return is_out(now); }

  const FixedArm& arm;
  DrawnArm drawn;
  std::unique_ptr<AnyGuardState> state;
  Guard guard;
  std::vector<Promise> promises;
  Values now;
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
    }
  });
  CHECK(moved > commands / 10);  // an arm whose links touch stands still
}

TEST_CASE("limit: arms that are inside their stop distance come out") {
  int inside = 0;
  int out = 0;
  for_rounds(rounds(30, 400), 1, [&](Random& random, int) {
    const FixedArm arm(any_guarded_arm(random, 3, 5e-4));
    Values from;
    Values to;
    bool can_be_out = false;
    for (int tries = 0; tries < 100 && from.empty(); ++tries) {
      from = arm.any_values(random);
      const Commanded there(arm, from);
      const auto is_touching = [](const Promise& of) { return of.is_touching(); };
      if (there.is_out() ||
          std::any_of(there.promises.begin(), there.promises.end(), is_touching)) {
        from.clear();
      }
      to = arm.any_values(random);
      can_be_out = can_be_out || there.is_out(to);
    }
    if (from.empty() || !can_be_out) {  // some pairs are nowhere out
      return;
    }
    Commanded commanded(arm, from);
    ++inside;
    for (int target = 0; target < 20 && !commanded.is_out(); ++target) {
      for (int tries = 0; tries < 100 && !commanded.is_out(to); ++tries) {
        to = arm.any_values(random);
      }
      for (int i = 0; i < 200 && !commanded.is_out(); ++i) {
        const Values wanted = step_towards(arm, commanded.now, to, 0.02);
        if (commanded.command(wanted, UINT32_MAX, random).share == 0) {
          break;
        }
      }
    }
    out += commanded.is_out() ? 1 : 0;
  });
  CAPTURE(inside, out);
  CHECK(inside > 3);
  CHECK(out * 4 >= inside);  // others are held by pairs that are nearly nowhere out
}

namespace {

constexpr double kSlideCell = 1e-3;

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
  CHECK(slide.metres() < 0.592);  // a tenth of the stop distance, in all
  for (const double metres : {0.58, 0.6, 0.57, 0.6, 0.56, 0.6}) {
    const double floor = slide.guard.floor(0) * kSlideCell / 256;
    (void)slide.command(metres);
    CHECK(0.6 - slide.metres() > floor - 0.002 - 0.001);
  }
  CHECK(slide.metres() < 0.6 - 0.018);
}

TEST_CASE("limit: too little work slows a command and does not stop it") {
  Slide slide;
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
  REQUIRE(slide.guard.release(0, {256}) == Status::done);  // 1 mm a command
  int commands = 0;
  for (; slide.guard.floor(0) == 0 && commands < 100; ++commands) {
    const double before = slide.metres();
    (void)slide.command(0.3);
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
  for_rounds(rounds(2000, 20'000), [&](Random& random, int) {
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
