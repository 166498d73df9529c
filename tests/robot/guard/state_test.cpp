// The guard's state: refused values; stored, restored and damaged states.
#include <type_traits>

#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

static_assert(std::is_trivially_copyable<AnyGuardState>::value, "a state may be copied");

/// A state with every byte defined, for comparisons.
std::unique_ptr<AnyGuardState> no_state() {
  auto state = std::make_unique<AnyGuardState>();
  std::memset(static_cast<void*>(state.get()), 0, sizeof *state);
  return state;
}

void copy(const AnyGuardState& from, AnyGuardState& to) {
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
}

/// Whether two states are equal but for scratch: frames, and the refused next values.
bool are_same(const FixedArm& arm, const AnyGuardState& u, const AnyGuardState& v) {
  const Robot& robot = arm.robot();
  const std::size_t joints = robot.joint_count * sizeof(JointCoordinate);
  const GuardCore& c = u.core;
  const GuardCore& d = v.core;
  const bool walks = c.walked_pair != kNoPair;
  return c.walked_pair == d.walked_pair &&
         (!walks ||
          (c.asked == d.asked && c.nearest == d.nearest && c.witness.a == d.witness.a &&
           c.witness.b == d.witness.b && c.cursor.a == d.cursor.a && c.cursor.b == d.cursor.b &&
           c.cursor.untested == d.cursor.untested && c.cursor.state == d.cursor.state &&
           std::memcmp(u.walked, v.walked, joints) == 0)) &&
         std::memcmp(u.before, v.before, joints) == 0 && std::memcmp(u.step, v.step, joints) == 0 &&
         std::memcmp(u.pairs, v.pairs, robot.pair_count * sizeof(GuardPair)) == 0 &&
         std::memcmp(u.certified, v.certified, sizeof u.certified) == 0;
}

/// Random values that are refused; returns the reason.
Status any_refused(Random& random, const FixedArm& arm, const Values& last, Values& values) {
  const std::uint32_t i = random.below(static_cast<std::uint32_t>(values.size()));
  if (random.below(2) == 0) {
    values[i] = kNoCoordinate;
    return Status::not_a_coordinate;
  }
  if (arm.is_free(i)) {
    values[i] = last[i] + kFullTurn / 2;
    return Status::joint_jumped;
  }
  values[i] = random.below(2) == 0 ? arm.joint_of(i).lower - 1 : arm.joint_of(i).upper + 1;
  return Status::joint_out_of_limits;
}

constexpr std::uint32_t kBudgets[] = {1, 5, 40, 300, UINT32_MAX};

}  // namespace

TEST_CASE("refused values change nothing, and a state taken up goes on as if it never stopped") {
  for_rounds(3, [&](Random& random, int round) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    const auto plain = no_state();
    const auto used = no_state();
    const auto stored = no_state();
    Guard guard(arm.robot(), *plain);
    Guard other(arm.robot(), *used);
    Wandering wandering(arm, arm.any_values(random), 0.01);
    Values last;
    for (int i = 0; i < 300; ++i) {
      CAPTURE(round, i);
      const Values now = wandering.step(random);
      Values refused = now;
      if (i != 0 && random.below(2) == 0) {
        refused = last;
        const Status wanted = any_refused(random, arm, last, refused);
        const GuardAnswer answer = other.update(refused.data(), 100);
        CHECK(answer.status == wanted);
        CHECK(answer.verdict == Verdict::refused);
      }
      const std::uint32_t work = kBudgets[random.below(5)];
      const GuardAnswer wanted = guard.update(now.data(), work);
      REQUIRE(are_same(other.update(now.data(), work), wanted));
      REQUIRE(are_same(arm, *plain, *used));
      if (random.below(3) == 0) {  // continues with a copy, in the middle of a walk or not
        copy(*used, *stored);
        std::memset(static_cast<void*>(used.get()), 0xA5, sizeof *used);
        new (&other) Guard(arm.robot(), *used);
        copy(*stored, *used);
        REQUIRE(other.resume() == Status::done);
      }
      if (random.below(3) == 0) {  // more work for the current period
        REQUIRE(are_same(other.go_on(work), guard.go_on(work)));
        REQUIRE(are_same(arm, *plain, *used));
      }
      last = now;
    }
  });
}

TEST_CASE("go_on() comes to know what update() did not; prime() knows it at once") {
  for_rounds(3, [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
    const auto state = no_state();
    Guard guard(arm.robot(), *state);
    for (int i = 0; i < 8; ++i) {
      const Values values = arm.any_values(random);
      const GuardAnswer primed = guard.prime(values.data());
      CHECK(primed.status == Status::done);
      CHECK(primed.verdict != Verdict::not_yet_known);
      guard.forget();
      GuardAnswer answer = guard.update(values.data(), 1);
      int periods = 0;
      for (; answer.verdict == Verdict::not_yet_known && periods < 100'000; ++periods) {
        answer = guard.go_on(1);
      }
      CHECK(answer.verdict != Verdict::not_yet_known);
      CHECK(guard.go_on(UINT32_MAX).verdict == primed.verdict);
    }
  });
}

TEST_CASE("what is no state of this guard") {
  Random random(test_seed());
  const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
  const FixedArm another = any_guarded_arm(random, 3, 1e-3);
  const Values values = arm.any_values(random);
  const auto state = no_state();
  Guard guard(arm.robot(), *state);
  CHECK(guard.go_on(1).status == Status::guard_state_invalid);
  CHECK(guard.go_on(1).verdict == Verdict::refused);
  CHECK(guard.prime(values.data()).status == Status::done);
  const auto stored = no_state();
  copy(*state, *stored);
  Guard others(another.robot(), *state);
  copy(*stored, *state);
  CHECK(others.resume() == Status::guard_state_invalid);
  CHECK(others.go_on(1).status == Status::guard_state_invalid);

  GuardStateOf<1, 1, 1> small;
  Guard none(arm.robot(), small);
  CHECK(none.update(values.data(), 1).status == Status::guard_state_invalid);
  CHECK(none.go_on(1).status == Status::guard_state_invalid);
  CHECK(none.prime(values.data()).status == Status::guard_state_invalid);
  CHECK(none.resume() == Status::guard_state_invalid);
  std::int32_t changes[8];
  CHECK(none.explain(0, changes).status == Status::guard_state_invalid);
}

TEST_CASE("half a turn of a joint, or of its mimic, is ambiguous") {
  Model model;
  // Two other joints come first: a joint and its mimic.
  const std::size_t other = add_joint(model, tool::kNoJoint, {}, JointType::revolute, -1, 1);
  const std::size_t its_mimic = add_mimic(model, other, {}, JointType::revolute, 0, 1, 0);
  const std::size_t master = add_joint(model, its_mimic, {}, JointType::continuous, -kPi, kPi);
  const std::size_t mimic =
      add_mimic(model, master, shifted({0.5, 0, 0}), JointType::continuous, 1, -3, 0);
  add_link(model, tool::kNoJoint, box({-1, -1, -1}, {-0.9, 1, 1}));
  add_link(model, mimic, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 1e-3, {{0, 1, 0.01, 0.02}});
  const auto state = no_state();
  Guard guard(arm.robot(), *state);
  const auto status_of_step = [&](JointCoordinate step) {
    const Values from = {0, 12345};
    (void)guard.prime(from.data());
    const Values to = {0, from[1] + step};
    return guard.update(to.data(), UINT32_MAX).status;
  };
  CHECK(status_of_step(kFullTurn / 2) == Status::joint_jumped);
  CHECK(status_of_step(-kFullTurn / 2) == Status::joint_jumped);
  CHECK(status_of_step(kFullTurn / 6 - 4) == Status::done);
  CHECK(status_of_step(-kFullTurn / 6 + 4) == Status::done);
  // The mimic turns by more than half a turn, so it does not go the shorter way.
  CHECK(status_of_step(kFullTurn / 5) == Status::joint_jumped);
  CHECK(status_of_step(-kFullTurn / 5) == Status::joint_jumped);
  CHECK(status_of_step(kFullTurn / 3) == Status::joint_jumped);
  CHECK(status_of_step(kFullTurn / 100) == Status::done);
  for (const JointCoordinate beyond : {kFullTurn + 1, -kFullTurn - 1}) {
    CHECK(status_of_step(1) == Status::done);
    state->before[master] = beyond;
    CHECK(guard.resume() == Status::guard_state_invalid);
  }
}

TEST_CASE("a damaged state is refused, or the guard goes on and comes to an end") {
  long taken = 0;
  long refused = 0;
  for_rounds(2, [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    const auto state = no_state();
    const auto stored = no_state();
    Guard guard(arm.robot(), *state);
    Wandering wandering(arm, arm.any_values(random), 0.01);
    for (int i = 0; i < 20 || (state->core.walked_pair == kNoPair && i < 500); ++i) {
      (void)guard.update(wandering.step(random).data(), 20);
    }
    copy(*state, *stored);
    const Values now = wandering.step(random);
    const auto go_on_with = [&](std::size_t flips) {
      copy(*stored, *state);
      auto* const bytes = reinterpret_cast<unsigned char*>(state.get());
      for (std::size_t flip = 0; flip < flips; ++flip) {
        const std::uint32_t in_core = random.below(2) == 0 ? sizeof(GuardCore) : sizeof *state;
        bytes[random.below(in_core)] ^= static_cast<unsigned char>(1 + random.below(255));
      }
      const bool is_taken = guard.resume() == Status::done;
      (is_taken ? taken : refused) += 1;
      (void)guard.go_on(7);
      for (const std::uint32_t work : {1u, 100u, UINT32_MAX}) {
        (void)guard.update(now.data(), work);
      }
    };
    for (std::size_t at = 0; at < sizeof(AnyGuardState); ++at) {
      copy(*stored, *state);
      auto* const bytes = reinterpret_cast<unsigned char*>(state.get());
      bytes[at] = static_cast<unsigned char>(bytes[at] ^ 0xFF);
      (guard.resume() == Status::done ? taken : refused) += 1;
      (void)guard.update(now.data(), 100);
      (void)guard.update(now.data(), UINT32_MAX);
    }
    for (int i = 0; i < 1000; ++i) {
      go_on_with(1 + random.below(6));
    }
  });
  CHECK(taken > 100);
  CHECK(refused > 100);
}
