// The effects of a flipped bit on a guard if verify() is not called.
//
// A guard moves towards a collision, with its certificates in place. Each bit of its state is
// flipped in turn; then the guard continues, and brute force checks each period that it permits.
#include <cstddef>
#include <iostream>

#include "flashbvh/robot.h"
#include "robot/baked/robot_image.hpp"
#include "safety/flips.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

constexpr int kPeriods = 100;         ///< of the whole motion
constexpr int kAhead[] = {2, 5, 12};  ///< the number of periods between the flip and the collision
constexpr int kLooked = 16;           ///< the number of periods checked after the flip
constexpr std::uint32_t kWork = 250;  ///< per period

#if defined(FLASHBVH_SANITIZE)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Numbers of flipped bits.
struct Counts {
  std::size_t bits = 0;
  std::uint32_t refused = 0;  ///< by resume()
  std::uint32_t wrong = 0;    ///< after which a period with a collision was permitted
};

/// Whether a byte of a guard's state belongs to the number of a pair or of a triangle: a damaged
/// one may lead out of the robot's arrays.
bool leads_out(std::size_t byte, const Robot& robot) {
  const auto is_at = [byte](std::size_t begin, std::size_t size) {
    return byte - begin < size;  // a difference below 0 wraps
  };
  constexpr std::size_t pair_size = sizeof(GuardPair);
  constexpr std::size_t witness_size = sizeof(GuardPair::witness);
  constexpr std::size_t witness_at = offsetof(GuardPair, witness);
  const std::size_t pairs =
      sizeof(GuardCore) + robot.joint_count * (sizeof(Frame) + 6 * sizeof(JointCoordinate));
  return is_at(offsetof(GuardCore, walked_pair), 2) ||
         is_at(offsetof(GuardCore, witness), witness_size) ||
         (is_at(pairs, robot.pair_count * pair_size) &&
          is_at(pairs + (byte - pairs) / pair_size * pair_size + witness_at, witness_size));
}

/// A guard in memory of exactly its size, so that the address sanitizer detects accesses outside.
struct GuardInMemory {
  explicit GuardInMemory(const FixedArm& arm) : robot(arm.robot()) {
    const std::uint32_t between = tool::pair_joint_count(arm.robot());
    words.resize(FLASHBVH_GUARD_STATE_SIZE(robot.joint_count, robot.pair_count, between) / 4);
  }
  Guard guard() { return Guard(robot, words.data(), words.size() * 4); }

  Robot robot;
  std::vector<std::uint32_t> words;
};

/// A motion from values with all pairs apart to values with some nearer than their stop distance.
struct Way {
  /// Whether some tries find such a motion for the arm.
  bool find(const FixedArm& arm, Random& random) {
    for (int i = 0; i < 200; ++i) {
      from = arm.any_values(random);
      to = arm.any_values(random);
      collision = 0;
      for (int at = 0; at <= kPeriods && collision == 0; ++at) {
        collision = is_too_near(arm, this->at(at)) ? at : 0;
        if (at == 0 && is_too_near(arm, from)) {
          break;
        }
      }
      if (collision > 12) {
        return true;
      }
    }
    return false;
  }
  Values at(int period) const {
    Values values;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::int64_t way = std::int64_t{to[i]} - from[i];
      values.push_back(static_cast<JointCoordinate>(from[i] + way * period / kPeriods));
    }
    return values;
  }
  /// Whether a pair is too near by more than the error of placing.
  static bool is_too_near(const FixedArm& arm, const Values& values) {
    for (std::uint32_t i = 0; i < arm.robot().pair_count; ++i) {
      const RobotPair& pair = arm.robot().pairs[i];
      if (pair.stop > 2 * kPlacingFine &&
          arm.is_closer(pair, values, pair.stop - 2 * kPlacingFine)) {
        return true;
      }
    }
    return false;
  }

  Values from;
  Values to;
  int collision = 0;
};

/// Whether a period from `begin` on is permitted in spite of a collision at its end.
bool permits_collision(Guard& guard, const Way& way, const std::vector<bool>& is_hit, int begin) {
  bool is_wrong = false;
  for (int i = 0; i < kLooked; ++i) {
    const GuardAnswer answer = guard.update(way.at(begin + i).data(), kWork);
    is_wrong = is_wrong || (answer.verdict <= Verdict::warn && is_hit[static_cast<std::size_t>(i)]);
  }
  return is_wrong;
}

/// Flips each bit, `ahead` periods before the collision. With `resumes`, resume() restores the
/// state and recomputes poses. Without, the guard continues, except after bits that resume()
/// refuses because they lead out of the robot's arrays. Returns whether a measurement was suspended
/// at the flip.
bool flip_all(const FixedArm& arm, const Way& way, int ahead, bool resumes, Counts& counts) {
  GuardInMemory memory(arm);
  const int begin = way.collision - ahead;
  Guard guard = memory.guard();
  for (int i = 0; i < begin; ++i) {
    REQUIRE(guard.update(way.at(i).data(), i == 0 ? UINT32_MAX : kWork).status == Status::done);
  }
  std::vector<bool> is_hit;
  for (int i = 0; i < kLooked; ++i) {
    is_hit.push_back(Way::is_too_near(arm, way.at(begin + i)));
  }
  std::vector<std::uint32_t> flipped = memory.words;
  const bool is_walk = reinterpret_cast<GuardCore*>(flipped.data())->walked_pair != kNoPair;
  REQUIRE_FALSE(permits_collision(guard, way, is_hit, begin));
  auto* const bytes = reinterpret_cast<unsigned char*>(flipped.data());
  for (std::size_t byte = 0; byte < 4 * flipped.size(); ++byte) {
    const bool stays = resumes || leads_out(byte, memory.robot);
    counts.wrong += count_flips(bytes + byte, 1, [&] {
      memory.words = flipped;
      const bool is_refused = guard.resume() != Status::done;
      counts.refused += is_refused ? 1 : 0;
      if (is_refused && stays) {
        return false;
      }
      memory.words = resumes ? memory.words : flipped;
      return permits_collision(guard, way, is_hit, begin);
    });
  }
  counts.bits += 32 * flipped.size();
  return is_walk;
}

}  // namespace

TEST_CASE("flipped bits without verify(): permitted collisions, counted; no crash, an end") {
  Random random(test_seed());
  for (const bool resumes : {true, false}) {
    if (kIsSanitized && !resumes) {
      continue;  // an unchecked pose exceeds the ranges of numbers
    }
    Counts counts;
    int walks = 0;
    for (int arms = 0; arms < 3;) {
      const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
      Way way;
      if (!way.find(arm, random)) {
        continue;
      }
      ++arms;
      for (const int ahead : kAhead) {
        walks += flip_all(arm, way, ahead, resumes, counts) ? 1 : 0;
      }
    }
    std::cout << (resumes ? "taken up by resume(): " : "as they are: ") << counts.bits << " bits, "
              << counts.refused << " refused by resume(), " << counts.wrong
              << " permit a collision\n";
    CHECK(walks > 1);
  }
}

TEST_CASE("verify() finds each flipped bit of guards of generated robots") {
  for_rounds(2, [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    GuardInMemory memory(arm);
    std::vector<Mesh> meshes(arm.robot().meshes, arm.robot().meshes + arm.robot().link_count);
    memory.robot.meshes = meshes.data();
    Guard guard = memory.guard();
    Wandering wandering(arm, arm.any_values(random), 0.01);
    auto& core = *reinterpret_cast<GuardCore*>(memory.words.data());
    for (int i = 0; i < 20 || (core.walked_pair == kNoPair && i < 500); ++i) {
      (void)guard.update(wandering.step(random).data(), 20);
    }
    guard.seal();
    const auto finds_all = [&](void* bytes, std::size_t size) {
      return guard.verify() == Status::done &&
             count_flips(bytes, size,
                         [&] { return guard.verify() == Status::guard_state_invalid; }) == 8 * size;
    };
    CHECK(finds_all(memory.words.data(), memory.words.size() * 4));
    CHECK(finds_all(&guard, sizeof guard));
    CHECK(finds_all(&memory.robot, sizeof memory.robot));
    CHECK(finds_all(meshes.data(), meshes.size() * sizeof meshes[0]));
  });
}

TEST_CASE("a sealed state that was stored is verified and taken up by another guard") {
  for_rounds(3, [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
    GuardInMemory memory(arm);
    GuardInMemory other(arm);
    Guard guard = memory.guard();
    Guard later = other.guard();
    CHECK(guard.verify() == Status::guard_state_invalid);  // not sealed
    Wandering wandering(arm, arm.any_values(random), 0.01);
    for (int i = 0; i < 30; ++i) {
      (void)guard.update(wandering.step(random).data(), 50);
    }
    guard.seal();
    later.seal();
    other.words = memory.words;
    REQUIRE(later.verify() == Status::done);
    REQUIRE(later.resume() == Status::done);
    const Values next = wandering.step(random);
    const GuardAnswer answer = guard.update(next.data(), 50);
    CHECK(answer.status == Status::done);
    CHECK(are_same(later.update(next.data(), 50), answer));
    guard.forget();
    CHECK(guard.verify() == Status::guard_state_invalid);  // changed since the seal
    memory.words[2 + random.below(20)] ^= 1u << random.below(32);
    other.words = memory.words;
    CHECK(later.verify() == Status::guard_state_invalid);
  });
}
