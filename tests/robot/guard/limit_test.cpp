// Guard::limit(): no pair of random arms gets nearer than its floor allows, arms inside their stop
// distance come out, and too little work slows them.
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
      for (int moment = 0; moment < 4 && floors[i] != kUnknownFloor; ++moment) {
        REQUIRE(promises[i].holds(drawn, period.at(moment, random), floors[i]));
      }
      promises[i].see(now);
      REQUIRE((guard.floor(i) == kUnknownFloor || promises[i].is_seen(guard.floor(i))));
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
  CHECK(moved > commands / 4);
}

TEST_CASE("limit: arms that are inside their stop distance come out") {
  int inside = 0;
  int out = 0;
  for_rounds(rounds(100, 400), 1, [&](Random& random, int) {
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
  CHECK(inside > 5);
  CHECK(out * 5 >= inside * 4);
}
