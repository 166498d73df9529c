// The formulas of flashbvh/time_bound.hpp.
#include "flashbvh/time_bound.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

using namespace flashbvh;

namespace {

constexpr RunCosts kCosts = {1000, 10, 6, 50, 200};
constexpr TreeSize kA = {9, 4, 3, 100, 250};
constexpr TreeSize kB = {11, 2, 1, 40, 40};
constexpr TreeSize kOneLeaf = {0, 0, 1, 1, 1};

// The example of lib/docs/bounded_time.md.
constexpr TreeSize kOfPage = {10, 4, 2, 600, 1100};

}  // namespace

TEST_CASE("bound: the most visits and the most work of a query") {
  STATIC_REQUIRE(most_visits(1, 1) == 1);
  STATIC_REQUIRE(most_visits(32768, 32768) == (uint64_t{1} << 31) - 1);
  STATIC_REQUIRE(most_work(kOneLeaf, kOneLeaf) == 3 + 32);
  // 7,999 visits, each after a resumed walk, 2,666 of them to leaves with planes, of three
  // triangles, 10,000 pairs of triangles; and another walk after each 65,535.
  STATIC_REQUIRE(most_work(kA, kB) == 3 * 7999 + 2666 * 10 + 10000 * 32 + 5 * 32);
}

TEST_CASE("bound: instructions are a start, a step that a run may overdraw by, and its work") {
  STATIC_REQUIRE(largest_step(kA, kB) == 32);
  STATIC_REQUIRE(largest_step(kB, {0, 0, 40, 1, 40}) == 48);
  STATIC_REQUIRE(instructions_of_start(kCosts, kA, kB) == 1000 + 20 * 10 + 4 * 6 + 2 * 50);
  STATIC_REQUIRE(instructions_of_work(kCosts, kA, kB) == 201);
  STATIC_REQUIRE(most_instructions(kCosts, kA, kB, 0) == 1324 + 31 * 201);
  STATIC_REQUIRE(most_instructions(kCosts, kA, kB, 100) == 1324 + 131 * 201);
  STATIC_REQUIRE(most_instructions(kCosts, kOneLeaf, kOneLeaf, 1) == 1000 + 32 * 200);
  STATIC_REQUIRE(most_instructions(kCosts, kA, kB, UINT32_MAX) ==
                 1324 + (uint64_t{UINT32_MAX} + 31) * 201);
}

TEST_CASE("bound: a mesh against itself passes by siblings at each ascent") {
  // 6 later siblings of both sides, and a test that finds none.
  STATIC_REQUIRE(most_instructions(kCosts, kA, 100) ==
                 1000 + 18 * (10 + 7 * 6) + 6 * 6 + 2 * 50 + 131 * (200 + 7 * 6));
  STATIC_REQUIRE(most_instructions(kCosts, kOneLeaf, 1) == 1000 + 32 * 206);
  STATIC_REQUIRE(work_within(most_instructions(kCosts, kA, 100) + 241, kCosts, kA) == 100);
  STATIC_REQUIRE(work_within(most_instructions(kCosts, kA, 100) - 1, kCosts, kA) == 99);
  STATIC_REQUIRE(work_within(UINT64_MAX, kCosts, kA) == UINT32_MAX - 1);
}

TEST_CASE("bound: the work within a number of instructions is the most that they are enough for") {
  for (const uint64_t instructions : {7555u, 7556u, 7755u, 7756u, 100000u, 12345678u}) {
    CAPTURE(instructions);
    const uint32_t work = work_within(instructions, kCosts, kA, kB);
    REQUIRE(most_instructions(kCosts, kA, kB, work) <= instructions);
    REQUIRE(most_instructions(kCosts, kA, kB, work + 1) > instructions);
  }
  STATIC_REQUIRE(work_within(7554, kCosts, kA, kB) == 0);
  STATIC_REQUIRE(work_within(UINT64_MAX, kCosts, kA, kB) == UINT32_MAX - 1);  // also a limit
}

TEST_CASE("bound: the constants of the cores, and what the page makes of one") {
  STATIC_REQUIRE(kCortexM4F.work < kCortexM0.work);
  const uint32_t work = work_within(56000, kCortexM4F, kOfPage, kOfPage);
  CHECK(work > 200);
  CHECK(work < 300);
}
