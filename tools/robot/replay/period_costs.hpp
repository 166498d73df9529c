// Estimates of a guard's periods on a core, by the work that they spend. They use means measured on
// another robot's guard (tests/figures/guard.cpp) and are no bounds; proven_period.hpp has bounds.
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

/// Costs for one robot, in instructions.
struct PeriodCosts {
  std::string core;  ///< "Cortex-M4F"
  double pass;       ///< each period: the frames of all joints, and a check of each pair
  double walk;       ///< in addition, for a period that spends work
  double work;       ///< per unit of work
  double longest;    ///< the longest period measured, as a multiple of the estimate for its work
};

/// The cores on which a guard was measured, in the form of --core: "cortex-m4f".
std::vector<std::string> measured_cores();
/// "Cortex-M4F" for "cortex-m4f". UserError, with a list of measured_cores(), for other cores.
std::string measured_name(const std::string& core);
/// UserError like measured_name().
PeriodCosts costs_on(const std::string& core, const Robot& robot);
/// A note on these estimates, for users.
std::string estimate_note(const PeriodCosts& costs);
double instructions_of(const PeriodCosts& costs, std::uint32_t work);

/// The percentiles in PeriodQuantiles; the last one is the maximum.
constexpr std::array<const char*, 4> kQuantileNames = {"50", "99", "99.9", "100"};
/// In instructions; all 0 if no period after the priming one was accepted.
using PeriodQuantiles = std::array<double, kQuantileNames.size()>;
/// Over the periods accepted after the priming one.
PeriodQuantiles quantiles_of(const PeriodCosts& costs, const std::vector<GuardAnswer>& answers);

/// Less than one in so many of a trajectory's periods may be `not_yet_known`.
constexpr std::size_t kOneUnknownIn = 1000;

struct LeastWork {
  std::uint32_t work;                ///< granted per period
  std::vector<GuardAnswer> answers;  ///< with it
};

/// The least work per period that keeps `not_yet_known` below 1 / kOneUnknownIn of this
/// trajectory's lines, by bisection with replays. One unit less leaves more; much less may not,
/// since more work does not always leave less unknown. None if unlimited work leaves more.
std::optional<LeastWork> least_work(const Robot& robot, const Trajectory& trajectory);

/// A core's clock, and how often the guard runs.
struct PeriodClock {
  double megahertz;
  double hertz;
  double cycles;  ///< per instruction, on average
  bool is_rough;  ///< `cycles` is no measurement

  /// The cycles of a period.
  double period_cycles() const { return megahertz * 1e6 / hertz; }
  double instructions() const { return period_cycles() / cycles; }
};

/// The mean cycles per instruction in a guard's periods, measured on a core in a part with that
/// flash; none if not measured.
std::optional<double> measured_cycles(const std::string& core, const std::string& flash);

/// The costs of a trajectory's periods on a core.
struct GuardTiming {
  PeriodCosts costs;
  PeriodQuantiles replayed;  ///< of the trajectory's answers
  std::optional<LeastWork> least;
  PeriodQuantiles of_least;  ///< of `least`, if there is one
  std::optional<PeriodClock> clock;
  std::uint32_t work;  ///< granted per replayed period; kAllWork: no limit
  std::optional<ProvenPeriod> proven;
};

/// "4165, about 5956 cycles, 0.0355 ms, 3.5 %". `cycles`: of a bound that is proven in cycles.
/// Without a clock there is no time. `whole` prints a whole number.
std::string cost_text(const GuardTiming& timing, double instructions,
                      std::optional<std::uint64_t> cycles, std::string (*whole)(double));

/// A period's work, and its proven bounds.
struct ProvenWork {
  std::uint32_t work;
  std::uint64_t instructions;
  std::optional<std::uint64_t> cycles;
};
/// Bounds for the granted work and for the least work, unless there is no limit or nothing is
/// proven.
std::vector<ProvenWork> proven_work(const GuardTiming& timing);
/// The most work whose proven cycles fit the period, or instructions if no cycles are proven; 0:
/// none.
std::uint32_t proven_work_within(const ProvenPeriod& proven, const PeriodClock& clock);

/// The most work whose estimate fits the period; none if the pass alone is longer.
std::optional<std::uint32_t> work_within(const PeriodCosts& costs, const PeriodClock& clock);

}  // namespace flashbvh::tool
