// What a guard's two halves share: looking at all pairs, measuring one.
#ifndef FLASHBVH_ROBOT_GUARD_PARTS_HPP
#define FLASHBVH_ROBOT_GUARD_PARTS_HPP

#include "branch.hpp"
#include "flashbvh/robot/guard.hpp"

namespace flashbvh {
namespace detail {

/// A certificate is measured again when it would run out within so many periods like the last one:
/// a measurement takes several of them.
constexpr uint32_t kPeriodsAhead = 5;

/// 1/256 cell that a certificate has to last beyond the period's motion.
constexpr uint32_t kRateMargin = 2;

/// What is known of a whole period, if the pair is `measured` apart where it ends, and was
/// `began` or more apart where it began. `lost`: the period's motion and the slack. The way from
/// either end to any moment adds up to the motion: the two distances may have lost half of it each.
constexpr uint32_t kept_of(uint32_t measured, uint32_t began, uint32_t lost, uint32_t slack) {
  const uint32_t by_end = difference_of(measured, lost);
  const auto by_both =
      static_cast<uint32_t>(difference_of(uint64_t{began} + measured, uint64_t{lost}) / 2);
  const uint32_t there = difference_of(measured, slack);
  const uint32_t by_most = by_both < there ? by_both : there;
  return by_end > by_most ? by_end : by_most;
}

/// How far apart a pair has to be where the period ends, to be farther than the limit at each
/// moment of it: the inverse of kept_of(). `moved`: in the period, and kRateMargin.
constexpr uint32_t lasting(uint32_t limit, uint32_t began, uint32_t moved, uint32_t slack) {
  const uint32_t by_end = difference_of(moved, difference_of(began, limit));
  return sum_of(sum_of(limit, slack), by_end > kRateMargin ? by_end : kRateMargin);
}

}  // namespace detail

/// What is left of a pair's certificate, in 1/256 cell, at any moment of this period.
struct Guard::Left {
  uint32_t lost;      ///< how far the links may have moved towards each other since, and the slack
  uint32_t distance;  ///< they are farther apart than that
  uint32_t left;      ///< of it, over the stop distance
  bool is_current;    ///< the certificate is of where the period ends
  bool is_settled;    ///< and to measure the pair again would show no more of the period
};

/// What one of the caller's variables has to do with a distance.
struct Guard::Share {
  int32_t change;  ///< a unit of it, in 2^-kReachBits of 1/256 cell
  int64_t way;     ///< all that it moved in this period
};

/// What looking at all pairs found.
struct Guard::Found {
  Verdict verdict;
  uint16_t pair;
  uint32_t distance;
  uint16_t due;  ///< to be measured first, or kNoPair
  uint32_t due_left;
  uint32_t due_rate;
  uint32_t walked_left;
  uint16_t vague;  ///< whether it is free or warned of is soon not known, or kNoPair
  uint32_t vague_left;
  uint32_t vague_rate;

  void take(Verdict of_pair, uint16_t i, uint32_t known) {
    if (of_pair > verdict || (of_pair == verdict && known < distance)) {
      verdict = of_pair;
      pair = i;
      distance = known;
    }
  }
  /// `left`: what it may still move. The one that runs out first is due first.
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

#endif
