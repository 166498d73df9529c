// What a guard's two halves share: looking at all pairs, measuring one.
#ifndef FLASHBVH_ROBOT_GUARD_PARTS_HPP
#define FLASHBVH_ROBOT_GUARD_PARTS_HPP

#include "flashbvh/robot/guard.hpp"

namespace flashbvh {
namespace detail {

/// A certificate is measured again when it would run out within so many periods like the last one:
/// a measurement takes several of them.
constexpr uint32_t kPeriodsAhead = 8;

/// 1/256 cell that a certificate has to last beyond the period's motion.
constexpr uint32_t kRateMargin = 2;

}  // namespace detail

/// What is left of a pair's certificate, in 1/256 cell, at any moment of this period.
struct Guard::Left {
  uint32_t lost;      ///< how far the links may have moved towards each other since, and the slack
  uint32_t distance;  ///< they are farther apart than that
  uint32_t left;      ///< of it, over the stop distance
  bool is_current;    ///< the certificate is of where the period ends
  bool is_settled;    ///< and to measure the pair again would show no more of the period
  bool is_vague;      ///< whether it is free or warned of is not known
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
  uint16_t vague;  ///< whether it is free or warned of is not known, or kNoPair
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
    if (due == kNoPair || uint64_t{left} * due_rate < uint64_t{due_left} * rate) {
      due = i;
      due_left = left;
      due_rate = rate;
    }
  }
};

}  // namespace flashbvh

#endif
