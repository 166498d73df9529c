// Guard::limit(): no pair of random arms gets nearer than its floor allows, and too little work
// slows them. That arms come out: way_out_test.
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
