// Shared by the parts of a guard that check all pairs and that measure one pair.
#pragma once

#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/robot/guard.hpp"

namespace flashbvh {
namespace detail {

/// A certificate is renewed if it would expire within this number of periods like the last one, as
/// a measurement takes several periods.
constexpr uint32_t kPeriodsAhead = 5;

/// Margin of a certificate beyond the period's motion, in 1/256 cell.
constexpr uint32_t kRateMargin = 2;

/// Lower bound on a pair's distance in the whole period, from `measured`, the distance at its end,
/// and `began`, a lower bound at its begin. `moved`: the period's motion. The motion from both ends
/// to any moment adds up to the period's, so each distance loses half of it.
constexpr uint32_t kept_of(uint32_t measured, uint32_t began, uint32_t moved) {
  const uint32_t by_end = difference_of(measured, moved);
  const auto by_both =
      static_cast<uint32_t>(difference_of(uint64_t{began} + measured, uint64_t{moved}) / 2);
  const uint32_t by_most = by_both < measured ? by_both : measured;
  return by_end > by_most ? by_end : by_most;
}

/// Distance at the period's end that keeps a pair beyond the limit at each moment of the period.
/// Inverse of kept_of(). `moved`: the period's motion and kRateMargin.
constexpr uint32_t lasting(uint32_t limit, uint32_t began, uint32_t moved) {
  const uint32_t by_end = difference_of(moved, difference_of(began, limit));
  return sum_of(limit, by_end > kRateMargin ? by_end : kRateMargin);
}

constexpr uint32_t smaller(uint32_t u, uint32_t v) {
  return u < v ? u : v;
}

}  // namespace detail

/// What a measurement found, in 1/256 cell.
struct Guard::Measured {
  uint32_t lower;
  uint32_t upper;
  Witness<uint16_t> witness;
};

/// The remaining certificate of a pair, in 1/256 cell, valid at each moment of this period.
/// Distances are those of the baked links, as measured.
struct Guard::Left {
  uint32_t moved;     ///< the links' motion towards each other since then, at most
  uint32_t distance;  ///< the links are farther apart than this
  uint32_t left;      ///< `distance` less the stop distance, or, inside it, less lowest_of()
  bool is_current;    ///< the certificate was measured where the period ends
  bool is_settled;    ///< measuring the pair again would prove no more of the period
};

/// What a pair may lose of its floor, as measured, in 1/256 cell.
struct Guard::Give {
  uint32_t most;      ///< a tenth of the stop distance, or some roundings
  uint32_t rounding;  ///< the part of Robot::slack that is not the links' deviation
  uint32_t of(uint32_t floor) const { return detail::smaller(most, floor / 2); }
};

/// Returns whether a joint without limits moved by less than half a turn, so that it took the
/// shorter arc. A mimic's motion follows from its master's.
template <class StepOf>
bool Guard::has_one_way(uint32_t i, StepOf&& step_of) const {
  const RobotJoint& joint = robot_->joints[i];
  if (joint.shift == 0) {
    return step_of(i) != -kFullTurn / 2;
  }
  uint32_t master = 0;
  while (robot_->joints[master].shift != 0 || robot_->joints[master].variable != joint.variable) {
    ++master;
  }
  const uint64_t way =
      uint64_t{detail::magnitude(step_of(master))} * detail::magnitude(joint.multiplier);
  return (way >> joint.shift) + 2 < kFullTurn / 2;  // each end is rounded
}

/// What a pair has to keep in a command, as measured, in 1/256 cell.
struct Guard::Keep {
  uint32_t most;   ///< Give::most
  uint32_t cap;    ///< of floors
  uint32_t along;  ///< at each moment
  uint32_t end;    ///< where the command ends
};

/// Bounds on a pair's distance from its certificate, while the joints go from the granted values to
/// the next ones.
struct Guard::Bounds {
  uint32_t along;   ///< lower bound at each moment
  uint32_t end;     ///< lower bound at the end
  uint32_t motion;  ///< of the links towards each other, at most
  bool is_current;  ///< the certificate was measured at the end
};

/// A variable's effect on a distance.
struct Guard::Share {
  int32_t change;  ///< per unit of the variable, in 2^-kReachBits of 1/256 cell
  int64_t way;     ///< in this period
};

/// Result of checking all pairs.
struct Guard::Found {
  Verdict verdict;
  uint16_t pair;
  uint32_t distance;
  uint16_t due;  ///< the pair to measure first, or kNoPair
  uint32_t due_left;
  uint32_t due_rate;
  uint32_t walked_left;
  uint16_t vague;  ///< pair that soon can't be decided between `free` and `warn`, or kNoPair
  uint32_t vague_left;
  uint32_t vague_rate;

  void take(Verdict of_pair, uint16_t i, uint32_t known) {
    if (of_pair > verdict || (of_pair == verdict && known < distance)) {
      verdict = of_pair;
      pair = i;
      distance = known;
    }
  }
  /// `left`: its remaining motion. The pair whose certificate expires first is due first.
  void take_due(uint16_t i, uint32_t left, uint32_t rate) {
    take_first(i, left, rate, due, due_left, due_rate);
  }
  void take_vague(uint16_t i, uint32_t left, uint32_t rate) {
    take_first(i, left, rate, vague, vague_left, vague_rate);
  }

 private:
  static void take_first(uint16_t i, uint32_t left, uint32_t rate, uint16_t& first,
                         uint32_t& first_left, uint32_t& first_rate) {
    if (first == kNoPair || uint64_t{left} * first_rate < uint64_t{first_left} * rate) {
      first = i;
      first_left = left;
      first_rate = rate;
    }
  }
};

}  // namespace flashbvh
