#include "report/budget.hpp"

#include <algorithm>
#include <cmath>

#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

Need need_of(std::uint64_t work, const TreeSize& a, const TreeSize& b, const Budget& budget) {
  const RunCosts& costs = budget.core.costs;
  const auto period = static_cast<std::uint64_t>(std::min(budget.instructions(), 1e18));
  // A single run spends what there is to do and no more.
  const double instructions =
      static_cast<double>(instructions_of_start(costs, a, b)) +
      static_cast<double>(work) * static_cast<double>(instructions_of_work(costs, a, b));
  return {work, instructions, work_within(period, costs, a, b)};
}

Need operator+(const Need& a, const Need& b) {
  return {a.work + b.work, a.instructions + b.instructions, 0, a.queries + b.queries};
}

std::string verdict(const Need& need, const Budget& budget) {
  const double share = need.share(budget);
  if (share <= 1) {
    return "fits in " +
           (share < 0.001 ? "less than 0.1" : fixed(100 * share, share < 0.1 ? 1 : 0)) +
           " % of the period";
  }
  if (need.queries > 1) {
    return "takes at most " +
           (share < 10 ? fixed(share, 1) : grouped(static_cast<std::uint64_t>(std::ceil(share)))) +
           " periods";
  }
  if (need.slice_work == 0) {
    return "no slice fits: the period is too short";
  }
  const std::uint64_t slices = (need.work + need.slice_work - 1) / need.slice_work;
  return "needs at most " + counted(slices, "slice", "slices") + " of " + grouped(need.slice_work) +
         " work";
}

std::string milliseconds(const Need& need, const Budget& budget) {
  const double time = need.instructions / (budget.mhz * 1e3);
  return (time >= 100 ? grouped(static_cast<std::uint64_t>(std::llround(time)))
                      : significant(time, 2)) +
         " ms";
}

}  // namespace flashbvh::tool
