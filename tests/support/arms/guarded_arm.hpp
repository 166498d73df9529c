// Arms with a guard, and brute force against it.
#pragma once

#include "flashbvh/robot/guard.hpp"
#include "support/arms/fixed_arm.hpp"

namespace flashbvh::test {

/// Room for any arm here.
using AnyGuardState = GuardStateOf<8, 32, 256>;

/// What placing rounds, in 1/256 cell.
constexpr std::uint32_t kPlacingFine = 228;

/// A period's values and what lies between: some joints lag, others lead. Joints without limits go
/// the shorter way.
class Period {
 public:
  Period(const FixedArm& arm, const Values& before, const Values& now);
  Values at_end() const { return now_; }
  Values at_start() const { return before_; }
  /// Each variable at its old value, at its new one, or between.
  Values between(Random& random) const;
  /// Of the moments that are tried: the start, the end, and any others.
  Values at(int moment, Random& random) const {
    return moment == 0 ? before_ : moment == 1 ? now_ : between(random);
  }
  /// How far the joints move the pair, in 1/256 cell.
  double travel(const FixedArm& arm, const RobotPair& pair) const;

 private:
  Values before_;
  Values now_;
};

/// Values that wander, each variable in a manner of its own.
class Wandering {
 public:
  /// `speed`: the largest step, of the joint's range.
  Wandering(const FixedArm& arm, const Values& from, double speed);
  const Values& step(Random& random);

 private:
  const FixedArm& arm_;
  Values values_;
  std::vector<double> velocity_;
  std::vector<std::uint32_t> manner_;
  double speed_;
};

/// A random arm whose pairs that can collide are guarded, at all kinds of distances.
FixedArm any_guarded_arm(Random& random, std::size_t joints, double cell);

/// The arm's links as they are drawn: baked with a cell that is a small part of the arm's, and put
/// where doubles say.
class DrawnArm {
 public:
  explicit DrawnArm(const FixedArm& arm) : arm_(arm), drawn_(arm.model, arm.arm.cell() / kFiner) {}

  /// In 1/256 of the arm's cell. False where it is unknown.
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

/// Primes the guard at values where it does not stop, if so many tries find some.
GuardAnswer prime_apart(Random& random, const FixedArm& arm, Guard& guard, int tries,
                        Values& values);

/// Empty, or what the answer promises and brute force contradicts.
const char* contradiction(const FixedArm& arm, const DrawnArm& drawn, const GuardAnswer& answer,
                          const Period& period, bool is_unlimited, Random& random);

}  // namespace flashbvh::test
