// Output of flashbvh guard about the time of periods.
#include <cmath>
#include <iomanip>
#include <iostream>

#include "cli/robot/guard_output.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string plain(double number) {
  return fixed(number, 0);
}

std::string estimate(const GuardTiming& timing, double instructions) {
  return cost_text(timing, instructions, std::nullopt, plain);
}

std::string head_of(const GuardTiming& timing) {
  const std::string text = "\ntime on a " + timing.costs.core;
  return timing.clock ? concat(text, " of ", significant(timing.clock->megahertz, 6), " MHz at ",
                               significant(timing.clock->hertz, 6), " Hz, ",
                               timing.clock->is_rough ? "roughly " : "about ",
                               significant(timing.clock->cycles, 3),
                               " cycles an instruction: instructions, time, and part of a period\n")
                      : text + ": instructions\n";
}

void print_row(int width, const std::string& name, const std::string& replayed,
               const std::string& least) {
  std::cout << std::left << std::setw(13) << name << std::setw(width) << replayed << least << "\n";
}

/// Prints "least work that keeps 'not yet known' below 0.1 % of periods: 96".
void print_least(const GuardTiming& timing) {
  std::cout << "least work that keeps 'not yet known' below 0.1 % of periods: "
            << (timing.least ? concat(timing.least->work) : "none does") << "\n";
  if (timing.clock) {
    const auto within = work_within(timing.costs, *timing.clock);
    std::cout << "a period has time for "
              << (within ? concat(*within, " work") : "less than a look at all pairs") << "\n";
  }
}

/// Prints "proven: with 680 work at most 1881169, 3402817 cycles, 20.3 ms, 2025.5 %".
void print_proven(const GuardTiming& timing) {
  if (!timing.proven) {
    std::cout << "proven: nothing of leaves with more than " << kMostBoundedLeaf << " triangles\n";
    return;
  }
  for (const ProvenWork& proven : proven_work(timing)) {
    std::cout << "proven: with " << proven.work << " work at most "
              << cost_text(timing, static_cast<double>(proven.instructions), proven.cycles, plain)
              << "\n";
  }
  if (timing.clock) {
    const std::uint32_t within = proven_work_within(*timing.proven, *timing.clock);
    std::cout << "proven: a period has time for "
              << (within != 0 ? concat(within, " work") : "no work") << "\n";
  }
}

}  // namespace

void print_timing(const GuardTiming& timing) {
  std::cout << head_of(timing);
  const int width = timing.clock ? 52 : 20;
  print_row(width, "of periods", "as replayed",
            timing.least ? concat("with ", timing.least->work, " work") : "");
  for (std::size_t i = 0; i < kQuantileNames.size(); ++i) {
    print_row(width, concat(kQuantileNames[i], " %"), estimate(timing, timing.replayed[i]),
              timing.least ? estimate(timing, timing.of_least[i]) : "");
  }
  print_least(timing);
  const PeriodCosts& costs = timing.costs;
  std::cout << "estimated: " << fixed(costs.pass, 0) << " a period, " << fixed(costs.walk, 0)
            << " more if it spends work, " << fixed(costs.work, 1) << " a unit of work.\n"
            << estimate_note(costs) << "\n";
  print_proven(timing);
}

}  // namespace flashbvh::tool
