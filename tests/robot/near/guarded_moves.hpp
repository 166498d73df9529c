// A guard on moves near contact, against brute-force distances.
#pragma once

#include "flashbvh/robot/guard.hpp"
#include "near_moves.hpp"

namespace flashbvh::test {

/// Numbers of periods, unless noted otherwise.
struct NearCounts {
  long periods = 0;
  long not_yet_known = 0;
  long warned = 0;
  long falsely_warned = 0;  ///< no pair within warn distance, the period's motion and two cells
  long unsound = 0;         ///< a pair is nearer than the verdict or the distance states
  long stops = 0;
  long far_stops = 0;    ///< more than 0.5 mm above the stop distance
  long early_stops = 0;  ///< more than two periods early, on the way to contact
  long most_early = 0;   ///< periods
  double most_over = 0;  ///< millimetres by which a stop exceeded the stop distance
  double sum_over = 0;
  std::uint64_t work = 0;
  std::uint32_t most_work = 0;
};

class GuardedMoves {
 public:
  GuardedMoves(const Robot& robot, const NearOptions& options, std::uint32_t budget);
  /// Primes the guard at a place, with unlimited work.
  void begin(const NearMoment& place);
  /// Moves there and back; turns back early where the guard stops.
  void run(const NearMove& move);
  const NearCounts& counts() const { return counts_; }
  std::uint32_t budget() const { return budget_; }

 private:
  /// Whether the move has to turn back.
  bool step(const NearMove& move, std::size_t from, std::size_t to, bool goes_on);
  void check(const NearMove& move, std::size_t from, std::size_t to, const GuardAnswer& answer);
  void count_stop(const NearMove& move, std::size_t at);

  NearScene scene_;
  std::uint32_t budget_;
  std::vector<std::uint64_t> memory_;
  Guard guard_;
  NearCounts counts_;
};

}  // namespace flashbvh::test
