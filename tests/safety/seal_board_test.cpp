// Sealed guards on each core: every flipped bit is detected.
#include <catch2/catch.hpp>

#include <initializer_list>

#include <stddef.h>
#include <string.h>

#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "safety/flips.hpp"
#include "support/print.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

using State = GuardStateOf<2, 1, 2>;

/// A revolute and a prismatic joint, and a pair of links that they move.
alignas(4) constexpr unsigned char kTwoLinks[] = {
#include "two_links.inc"
};

Mesh meshes[2];
Robot robot = view_robot_unchecked(kTwoLinks, meshes);
State state;
State stored;

/// A guard after some periods; `work`: the budget of each.
Guard moved_guard(uint32_t work) {
  memset(static_cast<void*>(&state), 0, sizeof state);
  Guard guard(robot, state);
  for (int i = 0; i < 8; ++i) {
    const JointCoordinate values[2] = {(i - 24) * (kFullTurn / 100), i * 300'000};
    (void)guard.update(values, work);
  }
  return guard;
}

/// Whether verify() detects each flipped bit of the memory, and finds none before and after.
bool finds_all(const Guard& guard, const char* name, void* memory, uint32_t size) {
  const auto is_found = [&] { return guard.verify() == Status::guard_state_invalid; };
  const bool was_good = !is_found();
  const uint32_t found = count_flips(memory, size, is_found);
  print("flipped bits of the ", name, ": ", found, " of ", 8 * size, " found\n");
  return was_good && found == 8 * size && !is_found();
}

}  // namespace

TEST_CASE("verify() finds the top bits of two words flipped, which products alone would lose") {
  Guard guard = moved_guard(UINT32_MAX);
  guard.seal();
  auto* const bytes = reinterpret_cast<unsigned char*>(&state);
  for (uint32_t at = offsetof(GuardCore, walked_pair) + 3; at + 4 < sizeof state; at += 4) {
    bytes[at] ^= 0x80;
    bytes[at + 4] ^= 0x80;
    REQUIRE(guard.verify() == Status::guard_state_invalid);
    bytes[at] ^= 0x80;
    bytes[at + 4] ^= 0x80;
  }
}

TEST_CASE(
    "verify() finds each flipped bit of the state, the guard and the views, at rest and in a "
    "walk") {
  for (const uint32_t work : {UINT32_MAX, uint32_t{20}}) {
    Guard guard = moved_guard(work);
    CHECK((state.core.walked_pair != kNoPair) == (work == 20));
    guard.seal();
    CHECK(finds_all(guard, "state", &state, sizeof state));
    CHECK(finds_all(guard, "guard", &guard, sizeof guard));
    CHECK(finds_all(guard, "robot's view", &robot, sizeof robot));
    CHECK(finds_all(guard, "meshes' views", meshes, sizeof meshes));
  }
}
