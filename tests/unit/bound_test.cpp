// The formulas of bound.hpp.
#include "flashbvh/bound.hpp"

#include <catch2/catch.hpp>

using namespace flashbvh;

namespace {

constexpr RunCosts kCosts = {100, 30, 10, 200, 6, 4000, 0};
constexpr TreePair kTrees = {20, 4, 9};

}  // namespace

TEST_CASE("the bound on visits is that of a tree of pairs") {
  STATIC_REQUIRE(most_visits(1, 1) == 1);
  STATIC_REQUIRE(most_visits(32768, 32768) == (uint64_t{1} << 31) - 1);
}

TEST_CASE("the bound on a run adds up its parts") {
  // The pair of leaves left by a full array is tested even by a run of no visits.
  STATIC_REQUIRE(most_instructions(kCosts, kTrees, {0, 0}) == 100 + 24 + 200 + 36000);
  STATIC_REQUIRE(most_instructions(kCosts, kTrees, {10, 0}) == 36324 + 10 * 40);
  STATIC_REQUIRE(most_instructions(kCosts, kTrees, {10, 3}) ==
                 36324 + 10 * 30 + 7 * 10 + 3 * (224 + 36000));
}

TEST_CASE("as many visits as fit, and no more") {
  constexpr uint64_t kGranted[] = {36324, 40000, 100000, 72577, 72578, 1000000000};
  for (const uint64_t instructions : kGranted) {
    const uint32_t visits = visits_within(instructions, kCosts, kTrees);
    CAPTURE(instructions, visits);
    REQUIRE(most_instructions(kCosts, kTrees, {visits, visits}) <= instructions);
    REQUIRE(most_instructions(kCosts, kTrees, {visits, 0}) <= instructions);
    REQUIRE(most_instructions(kCosts, kTrees, {visits + 1, visits + 1}) > instructions);
  }
  REQUIRE(visits_within(36323, kCosts, kTrees) == 0);
  REQUIRE(visits_within(UINT64_MAX, kCosts, kTrees) == UINT32_MAX);
}

TEST_CASE("the worked example of lib/docs/bounded_time.md") {
  constexpr RunCosts translated = {2001, 1118, 30, 1861, 12, 4363, 102};  // Cortex-M4F
  constexpr RunCosts general = {2001, 1118, 30, 1861, 12, 1453, 102};
  constexpr TreePair trees = {20, 6, 1};
  STATIC_REQUIRE(most_instructions(translated, trees, {1, 1}) == 14450);
  STATIC_REQUIRE(visits_within(56000, translated, trees) == 6);
  STATIC_REQUIRE(visits_within(56000, general, trees) == 11);
  STATIC_REQUIRE(most_instructions(translated, trees, {42, 0}) == 55252);
}
