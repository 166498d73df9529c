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
  long unsound = 0;  ///< a pair is nearer than the verdict or the distance states
  long stops = 0;
  long early_stops = 0;  ///< more than two periods early, on the way to contact
  long most_early = 0;   ///< periods
  std::uint64_t work = 0;
  std::uint32_t most_work = 0;

  NearCounts& operator+=(const NearCounts& more);
};

class GuardedMoves {
 public:
  GuardedMoves(const Robot& robot, const NearOptions& options, std::uint32_t budget);
  /// Primes the guard at a place, with unlimited work.
  void begin(const NearMoment& place);
  /// Moves there and back; turns back early where the guard stops.
  void run(const NearMove& move);
  const NearCounts& counts() const { return counts_; }

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
