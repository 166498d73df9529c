#include "cli/query/summary.hpp"
#include "cli/json.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "evaluate/needed_work.hpp"

namespace flashbvh::tool {
namespace {

/// Mean, 99th percentile and most.
using Three = std::array<std::uint64_t, 3>;

/// As most_instructions(), for any work.
std::uint64_t instructions_of(const RunCosts& costs, const TreeSize& a, const TreeSize& b,
                              std::uint64_t work) {
  return instructions_of_start(costs, a, b) +
         (work + largest_step(a, b) - 1) * instructions_of_work(costs, a, b);
}

Json json_of(const Three& numbers) {
  return {{"mean", numbers[0]}, {"percentile_99", numbers[1]}, {"most", numbers[2]}};
}

void print_row(const std::string& label, const Three& numbers) {
  std::cout << std::left << std::setw(12) << label << std::right;
  for (const std::uint64_t number : numbers) {
    std::cout << std::setw(16) << number;
  }
  std::cout << "\n";
}

}  // namespace

void print_summary(const ImageFile& a, const ImageFile& b, const std::string& algorithm,
                   const std::vector<std::uint64_t>& work, bool json) {
  const NeededWork needed = needed_work(work);
  const Three of_work = {static_cast<std::uint64_t>(std::llround(needed.mean)),
                         needed.percentile_99, needed.most};
  const TreeSize size_a = tree_size(a.header());
  const TreeSize size_b = tree_size(b.header());
  Json line = {{"poses", work.size()}, {"algorithm", algorithm}, {"work", json_of(of_work)}};
  if (!json) {
    std::cout << a.name() << " and " << b.name() << ", " << algorithm << ", " << work.size()
              << (work.size() == 1 ? " pose\n" : " poses\n")
              << "                        mean            99 %            most\n";
    print_row("work", of_work);
  }
  if (algorithm == "ranked") {
    if (!json) {
      std::cout << "instructions at most, all of a query in one run, GCC 12 at -O2\n";
    }
    for (const Core& core : kCores) {
      Three instructions{};
      for (std::size_t i = 0; i < instructions.size(); ++i) {
        instructions[i] = instructions_of(core.costs, size_a, size_b, of_work[i]);
      }
      line["instructions"][core.name] = json_of(instructions);
      if (!json) {
        print_row(core.name, instructions);
      }
    }
  }
  if (json) {
    print_object(line);
  }
}

}  // namespace flashbvh::tool
