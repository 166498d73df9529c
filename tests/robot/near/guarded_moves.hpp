// A guard on moves near contact, against distances by brute force.
#pragma once

#include "flashbvh/robot/guard.hpp"
#include "near_moves.hpp"

namespace flashbvh::test {

/// Counts of periods, but where it says otherwise.
struct NearCounts {
  long periods = 0;
  long not_yet_known = 0;
  long warned = 0;
  long falsely_warned = 0;  ///< no pair within the warn distance, the period's motion and two cells
  long unsound = 0;         ///< a pair nearer than the verdict or the distance says
  long stops = 0;
  long far_stops = 0;    ///< by more than 0.5 mm over the stop distance
  long early_stops = 0;  ///< by more than two periods, of those on the way to contact
  long most_early = 0;   ///< periods
  double most_over = 0;  ///< millimetres that a stop came over the stop distance
  double sum_over = 0;
  std::uint64_t work = 0;
  std::uint32_t most_work = 0;
};

class GuardedMoves {
 public:
  GuardedMoves(const Robot& robot, const NearOptions& options, std::uint32_t budget);
  /// At a place, with unlimited work.
  void begin(const NearMoment& place);
  /// There and back; from where the guard stops, back on the way it came.
  void run(const NearMove& move);
  const NearCounts& counts() const { return counts_; }
  std::uint32_t budget() const { return budget_; }

 private:
  /// Whether it has to turn back.
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
