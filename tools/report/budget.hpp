// Work against the time that there is for it: what flashbvh/bound.hpp proves of a core, in words.
#ifndef FLASHBVH_TOOLS_REPORT_BUDGET_HPP
#define FLASHBVH_TOOLS_REPORT_BUDGET_HPP

#include <cstdint>
#include <string>

#include "evaluate/needed_work.hpp"

namespace flashbvh::tool {

/// A period of a core.
struct Budget {
  Core core;
  double hz;   ///< periods a second
  double mhz;  ///< a million instructions a second: one a cycle

  double instructions() const { return mhz * 1e6 / hz; }  ///< of a period
};

/// What a whole query can take at most, or several one after the other.
struct Need {
  std::uint64_t work = 0;
  double instructions = 0;       ///< of a single run each
  std::uint64_t slice_work = 0;  ///< of a run that takes no longer than a period; 0: none does
  std::size_t queries = 1;

  double share(const Budget& budget) const { return instructions / budget.instructions(); }
};

Need need_of(std::uint64_t work, const TreeSize& a, const TreeSize& b, const Budget& budget);
Need operator+(const Need& a, const Need& b);

/// "fits in 37 % of the period", "needs at most 4 slices of 888 work"; of several queries, "takes
/// at most 3.2 periods".
std::string verdict(const Need& need, const Budget& budget);

/// "0.37 ms".
std::string milliseconds(const Need& need, const Budget& budget);

}  // namespace flashbvh::tool

#endif
