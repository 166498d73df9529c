#include "robot/replay/period_costs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The rows of tests/figures/budgets.csv that are read below, with the header first.
constexpr const char* kRows =
#include "guard_costs.inc"
    ;
/// The rows of tests/figures/cycles.csv that are read below.
constexpr const char* kCyclesRows =
#include "guard_cycles.inc"
    ;
/// A column of cycles.csv for a part, rather than for a core without flash.
struct MeasuredPart {
  const char* core;
  const char* flash;
  const char* column;
};
constexpr MeasuredPart kMeasuredParts[] = {{"Cortex-M4F", "stm32f4-5ws", "STM32F4"}};

/// Figures by name and core.
using Figures = std::map<std::string, std::map<std::string, double>>;

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::istringstream rest{std::string(line)};
  for (std::string cell; std::getline(rest, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

Figures measured_figures(const char* rows = kRows) {
  Figures figures;
  std::vector<std::string> head;
  for (Lines lines(rows); lines.next();) {
    const std::vector<std::string> cells = cells_of(lines.line());
    for (std::size_t i = 1; i < cells.size() && !head.empty(); ++i) {
      if (const auto value = parse_number(cells[i])) {
        figures[cells[0]][head[i]] = *value;
      }
    }
    head = head.empty() ? cells : head;
  }
  return figures;
}

bool is_known_enough(const std::vector<GuardAnswer>& answers) {
  const auto unknown = static_cast<std::size_t>(Verdict::not_yet_known);
  return summary_of(answers).periods[unknown] * kOneUnknownIn < answers.size();
}

}  // namespace

std::vector<std::string> measured_cores() {
  std::vector<std::string> cores;
  Figures figures = measured_figures();
  for (const auto& [core, value] : figures["guard.pass"]) {
    cores.push_back(lower_case(core));
  }
  return cores;
}

std::string measured_name(const std::string& core) {
  Figures figures = measured_figures();
  for (const auto& [name, value] : figures["guard.pass"]) {
    if (lower_case(name) == lower_case(core)) {
      return name;
    }
  }
  throw UserError("--core", "no guard was measured on ", tool::quoted(core), "; take one of ",
                  joined(measured_cores()));
}

PeriodCosts costs_on(const std::string& core, const Robot& robot) {
  const std::string name = measured_name(core);
  Figures figures = measured_figures();
  const auto figure = [&](const std::string& of) { return figures["guard." + of][name]; };
  const auto count = [&](const std::string& of) { return figures["guard." + of]["all"]; };
  const double frames = figure("kinematics");
  PeriodCosts costs = {name, figure("pass"), figure("walk"), figure("hundred_work") / 100, 0};
  costs.longest = figure("half.max") /
                  instructions_of(costs, static_cast<std::uint32_t>(count("work.half.max")));
  costs.pass = frames * robot.joint_count / count("joints") +
               (costs.pass - frames) * robot.pair_count / count("pairs");
  return costs;
}

std::string estimate_note(const PeriodCosts& costs) {
  return concat("These are means of a KUKA KR5's guard, whose longest period took ",
                fixed(costs.longest, 1), " times its estimate, and no bound.");
}

std::optional<double> measured_cycles(const std::string& core, const std::string& flash) {
  std::string column = flash == "none" ? core : "";
  for (const MeasuredPart& part : kMeasuredParts) {
    column = core == part.core && flash == part.flash ? part.column : column;
  }
  Figures cycles = measured_figures(kCyclesRows);
  Figures instructions = measured_figures();
  const char* const mean = "guard.half.mean";
  const auto found = cycles[mean].find(column);
  return found == cycles[mean].end() ? std::nullopt
                                     : std::make_optional(found->second / instructions[mean][core]);
}

std::string cost_text(const GuardTiming& timing, double instructions,
                      std::optional<std::uint64_t> cycles, std::string (*whole)(double)) {
  std::string text = whole(instructions);
  if (!timing.clock && !cycles) {
    return text;
  }
  const double all = cycles ? static_cast<double>(*cycles) : instructions * timing.clock->cycles;
  text += concat(cycles                   ? ", "
                 : timing.clock->is_rough ? ", roughly "
                                          : ", about ",
                 whole(all), " cycles");
  return timing.clock ? concat(text, ", ", significant(all / timing.clock->megahertz / 1e3, 3),
                               " ms, ", fixed(100 * all / timing.clock->period_cycles(), 1), " %")
                      : text;
}

double instructions_of(const PeriodCosts& costs, std::uint32_t work) {
  return costs.pass + (work == 0 ? 0 : costs.walk + work * costs.work);
}

PeriodQuantiles quantiles_of(const PeriodCosts& costs, const std::vector<GuardAnswer>& answers) {
  std::vector<std::uint32_t> work;
  bool is_primed = false;
  for (const GuardAnswer& answer : answers) {
    if (answer.status == Status::done && is_primed) {
      work.push_back(answer.work);
    }
    is_primed = is_primed || answer.status == Status::done;
  }
  PeriodQuantiles quantiles{};
  if (work.empty()) {
    return quantiles;
  }
  std::sort(work.begin(), work.end());
  constexpr std::array<std::size_t, 4> kAbove = {500, 10, 1, 0};  // of a thousand
  for (std::size_t i = 0; i < quantiles.size(); ++i) {
    quantiles[i] = instructions_of(costs, work[work.size() - 1 - work.size() * kAbove[i] / 1000]);
  }
  return quantiles;
}

std::optional<LeastWork> least_work(const Robot& robot, const Trajectory& trajectory) {
  LeastWork least = {kAllWork, replay(robot, trajectory, kAllWork)};
  if (!is_known_enough(least.answers)) {
    return std::nullopt;
  }
  const auto take_if_enough = [&](std::uint32_t work) {
    std::vector<GuardAnswer> answers = replay(robot, trajectory, work);
    const bool is_enough = is_known_enough(answers);
    if (is_enough) {
      least = {work, std::move(answers)};
    }
    return is_enough;
  };
  // The work of the longest period suffices, except for work that a guard does in advance.
  std::uint32_t enough = std::max(1u, summary_of(least.answers).most);
  while (!take_if_enough(enough)) {
    enough = enough > kAllWork / 2 ? kAllWork : 2 * enough;
  }
  for (std::uint32_t few = 0; least.work - few > 1;) {
    const std::uint32_t middle = few + (least.work - few) / 2;
    few = take_if_enough(middle) ? few : middle;
  }
  return least;
}

std::optional<std::uint32_t> work_within(const PeriodCosts& costs, const PeriodClock& clock) {
  const double left = clock.instructions() - costs.pass;
  if (left < 0) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(
      std::clamp((left - costs.walk) / costs.work, 0.0, static_cast<double>(kAllWork)));
}

std::vector<ProvenWork> proven_work(const GuardTiming& timing) {
  std::vector<ProvenWork> proven;
  const auto add = [&](std::uint32_t work) {
    if (const auto most = timing.proven ? timing.proven->most(work) : std::nullopt) {
      proven.push_back({work, *most, timing.proven->most_cycles(work)});
    }
  };
  add(timing.work);
  if (timing.least && timing.least->work != timing.work) {
    add(timing.least->work);
  }
  return proven;
}

std::uint32_t proven_work_within(const ProvenPeriod& proven, const PeriodClock& clock) {
  const double within = proven.cycles ? clock.period_cycles() : clock.instructions();
  return work_within(static_cast<std::uint64_t>(std::min(within, 0x1p62)),
                     proven.cycles.value_or(proven.costs), proven.size);
}

}  // namespace flashbvh::tool
