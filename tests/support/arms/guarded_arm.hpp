// Guarded arms, and brute force that checks the guard.
#pragma once

#include "flashbvh/robot/guard.hpp"
#include "support/arms/fixed_arm.hpp"

namespace flashbvh::test {

/// Storage for any arm of these tests.
using AnyGuardState = GuardStateOf<8, 32, 256>;

/// The rounding error of placing a link, in 1/256 cell.
constexpr std::uint32_t kPlacingFine = 228;

/// A period's first and last values, and any between: some joints lag, others lead. Joints without
/// limits go the shorter way.
class Period {
 public:
  Period(const FixedArm& arm, const Values& before, const Values& now);
  Values at_end() const { return now_; }
  /// Each variable at its old value, at its new one, or between.
  Values between(Random& random) const;
  /// Values at a moment: 0 is the start, 1 the end, any other one a random moment between.
  Values at(int moment, Random& random) const {
    return moment == 0 ? before_ : moment == 1 ? now_ : between(random);
  }
  /// The distance by which the joints move the pair, in 1/256 cell.
  double travel(const FixedArm& arm, const RobotPair& pair) const;

 private:
  Values before_;
  Values now_;
};

/// Values that wander, each variable in its own manner.
class Wandering {
 public:
  /// `speed`: the largest step, as a part of the joint's range.
  Wandering(const FixedArm& arm, const Values& from, double speed);
  const Values& step(Random& random);

 private:
  const FixedArm& arm_;
  Values values_;
  std::vector<double> velocity_;
  std::vector<std::uint32_t> manner_;
  double speed_;
};

/// A random arm whose pairs that can collide are guarded, at random distances.
FixedArm any_guarded_arm(Random& random, std::size_t joints, double cell);

/// The arm's links as drawn: baked with a small part of the arm's cell, and placed in doubles.
class DrawnArm {
 public:
  explicit DrawnArm(const FixedArm& arm) : arm_(arm), drawn_(arm.model, arm.arm.cell() / kFiner) {}

  /// Whether a pair is closer than `distance`, in 1/256 of the arm's cell. False if unknown.
  bool is_closer(const RobotPair& pair, const Values& values, std::uint32_t distance) const;

 private:
  static constexpr std::uint32_t kFiner = 32;

  const FixedArm& arm_;
  BakedArm drawn_;
};

inline bool are_same(const GuardAnswer& u, const GuardAnswer& v) {
  return u.status == v.status && u.verdict == v.verdict && u.pair == v.pair &&
         u.distance == v.distance && u.work == v.work;
}

/// Primes the guard at values where it does not stop, if `tries` more tries find some.
GuardAnswer prime_apart(Random& random, const FixedArm& arm, Guard& guard, int tries,
                        Values& values);

/// Whether the answer's promises hold at one moment. `is_within(pair, limit)`: whether a pair is
/// nearer than a limit, in 1/256 cell.
template <class IsWithin>
bool holds(const Robot& robot, const GuardAnswer& answer, const IsWithin& is_within) {
  bool is = answer.status == Status::done &&
            (answer.distance < 2 || !is_within(robot.pairs[answer.pair], answer.distance - 1));
  for (std::uint32_t i = 0; is && answer.verdict <= Verdict::warn && i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    is = !is_within(pair, answer.verdict == Verdict::free ? pair.warn : pair.stop);
  }
  return is;
}

/// The promise of the answer that brute force contradicts; nullptr if there is none.
const char* contradiction(const FixedArm& arm, const DrawnArm& drawn, const GuardAnswer& answer,
                          const Period& period, bool is_unlimited, Random& random);

}  // namespace flashbvh::test
