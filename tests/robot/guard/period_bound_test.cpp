// The formulas of flashbvh/robot/period_bound.hpp.
#include "flashbvh/robot/period_bound.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

using namespace flashbvh;

namespace {

constexpr GuardCosts kCosts = {50000, 800, 10, 900, 90, 80, 7000, 20, 19000, 1000};
// Six joints; four pairs, two with tables; ten joints in between.
constexpr GuardSize kSize = {6, 4, 10, 2, 20, 2};
constexpr GuardSize kNothing = {0, 0, 0, 0, 0, 0};

constexpr uint64_t kLook = 4 * 900 + 10 * 90 + (6 + 24) * 10 + 2 * 2 * (4 + 2 + 2) * 80;
constexpr uint64_t kAround = (24 + 12) * 10 + 12 * 90;
constexpr uint64_t kStart = 50000 + 6 * (800 + 60) + 20 * 20 + 4 * 4 * 19000;
constexpr uint64_t kOfWork = 1000 + 7;  // (540 + 40) / 85, rounded up

}  // namespace

TEST_CASE("bound: a period looks at all pairs twice, and again for each pair that it measures") {
  STATIC_REQUIRE(most_instructions(kCosts, kNothing, 0) == 50000 + 71 * 1000);
  STATIC_REQUIRE(most_instructions(kCosts, kSize, 0) ==
                 kStart + 2 * kLook + kAround + 77 * kOfWork);
  STATIC_REQUIRE(most_instructions(kCosts, kSize, 17) ==
                 kStart + 4 * kLook + 2 * 7000 + 3 * kAround + 94 * kOfWork);
}

TEST_CASE("bound: a period measures no pair twice") {
  constexpr uint64_t all = kStart + 6 * kLook + 4 * 7000 + 5 * kAround;
  STATIC_REQUIRE(most_instructions(kCosts, kSize, 96) == all + 173 * kOfWork);
  STATIC_REQUIRE(most_instructions(kCosts, kSize, 1000) == all + 1077 * kOfWork);
  STATIC_REQUIRE(most_instructions(kCosts, kSize, UINT32_MAX) ==
                 all + (uint64_t{UINT32_MAX} + 77) * kOfWork);
}

TEST_CASE("bound: the work within a period is the most that the instructions are enough for") {
  for (const uint64_t instructions : {500000u, 501006u, 501007u, 800000u, 12345678u}) {
    CAPTURE(instructions);
    const uint32_t work = work_within(instructions, kCosts, kSize);
    REQUIRE(work != 0);
    REQUIRE(most_instructions(kCosts, kSize, work) <= instructions);
    REQUIRE(most_instructions(kCosts, kSize, work + 1) > instructions);
  }
  STATIC_REQUIRE(work_within(most_instructions(kCosts, kSize, 1) - 1, kCosts, kSize) == 0);
  STATIC_REQUIRE(work_within(UINT64_MAX, kCosts, kSize) == UINT32_MAX - 1);  // also a limit
}

TEST_CASE(
    "bound: a period's cycles are those of memory without wait states, and of reads of flash") {
  constexpr GuardCycles core = {kCosts, {5, 4, 3, 2, 1, 6, 7, 8, 9, 10}};
  constexpr GuardCosts waits = {50010, 808, 16, 904, 92, 92, 7014, 36, 19018, 1020};
  STATIC_REQUIRE(most_cycles(core, 0, kSize, 96) == most_instructions(kCosts, kSize, 96));
  STATIC_REQUIRE(most_cycles(core, 2, kSize, 96) == most_instructions(waits, kSize, 96));
  STATIC_REQUIRE(work_within(1000000, core, 2, kSize) == work_within(1000000, waits, kSize));
}

TEST_CASE("bound: a guard's size has the joints between its pairs, and the pairs with tables") {
  const RobotPair pairs[] = {
      {0, 0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 2, 0, 1}, {0, 0, 0, 1, 2, 1, 1}, {0, 0, 0, 1, 3, 2, 2}};
  Robot robot = {};
  robot.joint_count = 5;
  robot.pair_count = 4;
  robot.pairs = pairs;
  const GuardSize size = guard_size_of(robot, 17, 3);
  CHECK(size.joints == 5);
  CHECK(size.pairs == 4);
  CHECK(size.pair_joints == 7);
  CHECK(size.tabled_pairs == 2);
  CHECK(size.depth == 17);
  CHECK(size.leaf_size == 3);
}
