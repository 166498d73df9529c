// The guard on random arms against brute force. FLASHBVH_PERIODS tries as many periods.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <cstring>
#include <memory>

#include "support/arms/guarded_arm.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using namespace flashbvh::test;

namespace {

long periods() {
  const char* const text = std::getenv("FLASHBVH_PERIODS");
  return text != nullptr ? std::atol(text) : rounds(3000L, 6000L);
}

constexpr std::uint32_t kBudgets[] = {1, 17, 60, 300, 2000, UINT32_MAX};
constexpr double kSpeeds[] = {1e-4, 1e-3, 1e-2, 0.1};

struct Verdicts {
  long of[4] = {};
};

/// Some 1,000 periods of one arm with one budget.
void walk(Random& random, const FixedArm& arm, const DrawnArm& drawn, long count,
          Verdicts& counts) {
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(arm.robot(), *state);
  const std::uint32_t budget = kBudgets[random.below(6)];
  Values before;
  GuardAnswer answer = prime_apart(random, arm, guard, 200, before);
  REQUIRE(answer.verdict != Verdict::not_yet_known);
  const long most = answer.verdict == Verdict::stop ? 20 : count;  // hardly ever free
  Wandering wandering(arm, before, kSpeeds[random.below(4)]);
  for (long i = 0; i < most; ++i) {
    const Values now = wandering.step(random);
    const Period period(arm, before, now);
    answer = guard.update(now.data(), budget);
    const char* const wrong =
        contradiction(arm, drawn, answer, period, budget == UINT32_MAX, random);
    if (wrong != nullptr) {
      CAPTURE(wrong, i, budget, answer.pair, answer.distance, static_cast<int>(answer.verdict));
      FAIL();
    }
    ++counts.of[static_cast<int>(answer.verdict)];
    before = now;
  }
}

}  // namespace

TEST_CASE("no verdict is contradicted on random arms, whatever the budget") {
  CAPTURE(test_seed());
  Random random(test_seed());
  Verdicts counts;
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
    walk(random, *arm, *drawn, kAtOnce, counts);
  }
  CAPTURE(counts.of[0], counts.of[1], counts.of[2], counts.of[3]);
  for (const long of : counts.of) {
    CHECK(of > 0);  // the test sees all of them
  }
}
