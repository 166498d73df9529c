// The guard on random arms against brute force, and the distance tables of these arms.
// FLASHBVH_PERIODS sets the number of periods.
#include "flashbvh/detail/robot/distance_table.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

long periods() {
  return number_in("FLASHBVH_PERIODS", rounds(1500L, 6000L));
}

constexpr std::uint32_t kBudgets[] = {1, 17, 60, 300, 2000, UINT32_MAX};
constexpr double kSpeeds[] = {1e-4, 1e-3, 1e-2, 0.1};

/// Guards a period, checked by brute force.
Verdict check_period(Random& random, const FixedArm& arm, const DrawnArm& drawn, Guard& guard,
                     const Values& before, const Values& now, std::uint32_t budget) {
  const GuardAnswer answer = guard.update(now.data(), budget);
  const char* const wrong =
      contradiction(arm, drawn, answer, Period(arm, before, now), budget == UINT32_MAX, random);
  if (wrong != nullptr) {
    CAPTURE(wrong, budget, answer.pair, answer.distance, static_cast<int>(answer.verdict));
    FAIL();
  }
  return answer.verdict;
}

/// About 1,000 periods of one arm with one budget.
void walk(Random& random, const FixedArm& arm, const DrawnArm& drawn, long count) {
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(arm.robot(), *state);
  const std::uint32_t budget = kBudgets[random.below(6)];
  Values before;
  const GuardAnswer answer = prime_apart(random, arm, guard, 200, before);
  REQUIRE(answer.verdict != Verdict::not_yet_known);
  const long most = answer.verdict == Verdict::stop ? 20 : count;  // seldom free
  Wandering wandering(arm, before, kSpeeds[random.below(4)]);
  for (long i = 0; i < most; ++i) {
    CAPTURE(i);
    const Values now = wandering.step(random);
    (void)check_period(random, arm, drawn, guard, before, now, budget);
    before = now;
  }
}

struct TableCounts {
  std::uint32_t places;  ///< that have a table value
  std::uint32_t all;
};

/// Checks at random values that no exact distance is less than the distance table's value.
TableCounts check_tables(const FixedArm& arm, Random& random) {
  TableCounts checked{};
  for (int i = 0; i < 2000; ++i) {
    const Values values = arm.any_values(random);
    const Values coordinates = coordinates_of(arm.robot(), values);
    REQUIRE_FALSE(coordinates.empty());
    for (std::uint16_t pair = 0; pair < arm.robot().pair_count; ++pair) {
      const RobotPair& of = arm.robot().pairs[pair];
      const std::uint32_t distance =
          detail::table_distance_at(arm.robot(), pair, coordinates.data());
      if (distance > kPlacingFine && arm.is_closer(of, values, distance - kPlacingFine)) {
        CAPTURE(i, pair, distance);
        FAIL();
      }
      checked.places += distance != 0 ? 1 : 0;
      checked.all += distance_table_size(arm.robot(), of) != 0 ? 1 : 0;
    }
  }
  return checked;
}

}  // namespace

TEST_CASE("no verdict is contradicted on random arms, whatever the budget") {
  Random random = test_random();
  constexpr long kAtOnce = 200;
  constexpr long kOfArm = 3;
  std::unique_ptr<FixedArm> arm;
  std::unique_ptr<DrawnArm> drawn;
  for (long done = 0; done < periods(); done += kAtOnce) {
    CAPTURE(done);
    if (done / kAtOnce % kOfArm == 0) {
      const double cell = random.below(2) == 0 ? 1e-3 : 4e-3;
      arm.reset(new FixedArm(any_guarded_arm(random, 3 + random.below(3), cell)));
      drawn = std::make_unique<DrawnArm>(*arm);
    }
    walk(random, *arm, *drawn, kAtOnce);
  }
}

TEST_CASE("each verdict comes where a block slides to a wall, and none is contradicted") {
  Model model;
  add_joint(model, kNoJoint, {}, JointType::prismatic, 0, 0.6);
  add_link(model, kNoJoint, box({-0.1, -0.1, 0.6}, {0.1, 0.1, 0.7}));
  add_link(model, 0, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 1e-3, {{0, 1, 0.02, 0.1}});
  const DrawnArm drawn(arm);
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(arm.robot(), *state);
  Random random = test_random();
  long verdicts[6] = {};
  Values before = {0};
  REQUIRE(guard.prime(before.data()).verdict == Verdict::free);
  for (int step = 1; step <= 100; ++step) {
    CAPTURE(step);
    const Values now = {static_cast<JointCoordinate>(0.005 * step / arm.unit_of(0))};
    ++verdicts[static_cast<int>(check_period(random, arm, drawn, guard, before, now, UINT32_MAX))];
    before = now;
  }
  CHECK((verdicts[0] > 70 && verdicts[1] > 10 && verdicts[4] > 0));
  guard.forget();
  CHECK(check_period(random, arm, drawn, guard, before, before, 0) == Verdict::not_yet_known);
}

TEST_CASE("nowhere are two links nearer than their distance table says") {
  std::uint32_t all = 0;
  for_rounds(rounds(4, 8), [&](Random& random, int) {
    all += check_tables(any_guarded_arm(random, 3, 1e-3), random).all;
  });
  CHECK(all > 0);
}

TEST_CASE("a distance table for which there was no time leaves the guard sound") {
  const auto check_with = [](FixedArm&& arm, std::int64_t looks, Random& random) {
    const Deadline deadline = after_looks(looks);
    arm.fixed.set_distance_tables(distance_tables_of(arm.model, arm.robot(), deadline));
    const TableCounts checked = check_tables(arm, random);
    walk(random, arm, DrawnArm(arm), 100);
    return checked.places;
  };
  for_rounds(rounds(2, 4), [&](Random& random, int) {
    CHECK(check_with(any_guarded_arm(random, 3, 1e-3), 0, random) == 0);
    check_with(any_guarded_arm(random, 3, 1e-3), 300, random);
  });
  Random random = test_random();
  const bake::SourceMesh pin = box({-0.01, 0.03, 0.1}, {0.01, 0.05, 0.15});
  FixedArm arm(blade_and(pin, -0.12, 0.12), 1e-3, {{0, 1, 0.01, 0.01}});
  constexpr std::int64_t kPlenty = 1'000'000'000;
  const Deadline whole = after_looks(kPlenty);
  distance_tables_of(arm.model, arm.robot(), whole);
  CHECK(check_with(std::move(arm), (kPlenty - *whole.looks) * 9 / 10, random) > 0);
}

TEST_CASE(
    "what lies in the sweep of a link, or next to it, is as near as it is, and a distance table "
    "says so") {
  Random random = test_random();
  const bake::SourceMesh pin = box({-0.01, 0.03, 0.1}, {0.01, 0.05, 0.15});
  const bake::SourceMesh wall = box({0.25, -0.1, 0}, {0.3, 0.1, 0.2});
  for (const double cell : {1e-3, 0.3 / 32765}) {  // the second fits the blade, not its sweep
    CAPTURE(cell);
    for (const bake::SourceMesh& mesh : {pin, wall}) {
      const FixedArm arm(blade_and(mesh, -0.12, 0.12), cell, {{0, 1, 0.01, 0.01}}, true);
      const TableCounts checked = check_tables(arm, random);
      CHECK((checked.places > checked.all / 10 && checked.all == 2000));
    }
  }
}

TEST_CASE("a byte's distance grows with it by a sixteenth at most") {
  CHECK(table_distance(0) == 0);
  for (std::uint32_t byte = 1; byte < 255; ++byte) {
    const double now = table_distance(static_cast<std::uint8_t>(byte));
    const double next = table_distance(static_cast<std::uint8_t>(byte + 1));
    CHECK((next > now && next <= now * 17 / 16));
  }
}
