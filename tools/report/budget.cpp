#include "report/budget.hpp"

#include <algorithm>
#include <cmath>

#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

Need need_of(std::uint64_t work, const TreeSize& a, const TreeSize& b, const Budget& budget) {
  const RunCosts& costs = budget.core.costs;
  Need need;
  need.work = work;
  // In one run, which spends what there is to do and no more.
  need.instructions =
      static_cast<double>(instructions_of_start(costs, a, b)) +
      static_cast<double>(work) * static_cast<double>(instructions_of_work(costs, a, b));
  if (need.share(budget) <= 1) {
    need.slices = 1;
    need.slice_work = work;
    return need;
  }
  const double period = std::min(budget.instructions(), 1e18);
  need.slice_work = work_within(static_cast<std::uint64_t>(period), costs, a, b);
  need.slices = need.slice_work == 0 ? 0 : (work + need.slice_work - 1) / need.slice_work;
  return need;
}

Need operator+(const Need& a, const Need& b) {
  const bool possible = a.slices != 0 && b.slices != 0;
  return {a.work + b.work, a.instructions + b.instructions, possible ? a.slices + b.slices : 0, 0};
}

std::string verdict(const Need& need, const Budget& budget) {
  const double share = need.share(budget);
  if (share <= 1) {
    return "fits in " +
           (share < 0.001 ? "less than 0.1" : fixed(100 * share, share < 0.1 ? 1 : 0)) +
           " % of the period";
  }
  if (need.slices == 0) {
    return "no slice fits: the period is too short";
  }
  return "needs at most " + counted(need.slices, "slice", "slices") +
         (need.slice_work == 0 ? "" : " of " + grouped(need.slice_work) + " work");
}

std::string milliseconds(const Need& need, const Budget& budget) {
  const double time = need.instructions / (budget.mhz * 1e3);
  return (time >= 100 ? grouped(static_cast<std::uint64_t>(std::llround(time)))
                      : significant(time, 2)) +
         " ms";
}

}  // namespace flashbvh::tool
