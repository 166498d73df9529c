// What a guard's periods take on a core: estimates by the work that they spend. The means that they
// are made of were measured on another robot's guard (tests/figures/guard.cpp); they are no bound.
// proven_period.hpp has one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/replay/proven_period.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {

/// Of one robot, in instructions.
struct PeriodCosts {
  std::string core;  ///< "Cortex-M4F"
  double pass;       ///< each period: the frames of all joints, and a look at each pair
  double walk;       ///< a period that spends work, in addition
  double work;       ///< a unit of work
  double longest;    ///< the longest period that was measured, by the estimate for as much work
};

/// The cores on which a guard was measured, as --core takes them: "cortex-m4f".
std::vector<std::string> measured_cores();
/// "Cortex-M4F" of "cortex-m4f". UserError, with a list of measured_cores(), unless it is one.
std::string measured_name(const std::string& core);
/// UserError as measured_name().
PeriodCosts costs_on(const std::string& core, const Robot& robot);
/// What these estimates are.
std::string estimate_note(const PeriodCosts& costs);
double instructions_of(const PeriodCosts& costs, std::uint32_t work);

/// The periods that PeriodQuantiles has: the parts of all that take no more; the last is the most.
constexpr std::array<const char*, 4> kQuantileNames = {"50", "99", "99.9", "100"};
/// Instructions; all 0 if no period but the one that primes was accepted.
using PeriodQuantiles = std::array<double, kQuantileNames.size()>;
/// Of the periods that are accepted after the one that primes.
PeriodQuantiles quantiles_of(const PeriodCosts& costs, const std::vector<GuardAnswer>& answers);

/// The part of a trajectory's periods that may be `not_yet_known`: less than one in so many.
constexpr std::size_t kOneUnknownIn = 1000;

struct LeastWork {
  std::uint32_t work;                ///< granted each period
  std::vector<GuardAnswer> answers;  ///< with it
};

/// The least work a period that keeps `not_yet_known` below 1 / kOneUnknownIn of this trajectory's
/// lines, by replays that halve the range. One unit less leaves more; much less may not, as more
/// work does not always leave less unknown. None if all the work leaves more.
std::optional<LeastWork> least_work(const Robot& robot, const Trajectory& trajectory);

/// A core's clock, and how often the guard runs.
struct PeriodClock {
  double megahertz;
  double hertz;
  double cycles;  ///< an instruction, on average
  bool is_rough;  ///< `cycles` is no measurement

  /// What a period has time for.
  double period_cycles() const { return megahertz * 1e6 / hertz; }
  double instructions() const { return period_cycles() / cycles; }
};

/// The cycles of an instruction of a guard's periods, as measured on a core in a part with that
/// flash; none where nothing was measured.
std::optional<double> measured_cycles(const std::string& core, const std::string& flash);

/// A trajectory's periods on a core.
struct GuardTiming {
  PeriodCosts costs;
  PeriodQuantiles replayed;  ///< of the trajectory's answers
  std::optional<LeastWork> least;
  PeriodQuantiles of_least;  ///< if there is one
  std::optional<PeriodClock> clock;
  std::uint32_t work;  ///< granted each period as replayed; kAllWork: no limit
  std::optional<ProvenPeriod> proven;
};

/// "4165, about 5956 cycles, 0.0355 ms, 3.5 %"; of a bound that is proven in `cycles`, those;
/// without a clock no time. `whole` prints a whole number.
std::string cost_text(const GuardTiming& timing, double instructions,
                      std::optional<std::uint64_t> cycles, std::string (*whole)(double));

/// A period's work, and the instructions and cycles that it is proven to take at most.
struct ProvenWork {
  std::uint32_t work;
  std::uint64_t instructions;
  std::optional<std::uint64_t> cycles;
};
/// Of the work granted, and of the least work; where there is no limit, or nothing is proven, of
/// neither.
std::vector<ProvenWork> proven_work(const GuardTiming& timing);
/// The most work whose proven cycles, or instructions where no cycles are proven, are no more than
/// the period has; 0: none.
std::uint32_t proven_work_within(const ProvenPeriod& proven, const PeriodClock& clock);

/// The most work whose estimate is no longer than the period; none if the pass is.
std::optional<std::uint32_t> work_within(const PeriodCosts& costs, const PeriodClock& clock);

}  // namespace flashbvh::tool
