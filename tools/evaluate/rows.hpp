// The rows of the tables: the traversals, each ready to run on one setup.
#ifndef FLASHBVH_TOOLS_EVALUATE_ROWS_HPP
#define FLASHBVH_TOOLS_EVALUATE_ROWS_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "evaluate/objects.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh::bench {

struct Row {
  const char* algorithm;  ///< by its name on the command line
  /// Runs the whole query that many times, geometry tests and all; the counts of the last.
  std::function<Counts(std::uint32_t repetitions)> run;
};

/// In the tables' order. 16-bit trees where both objects fit, else 32-bit ones. `a` and `b` outlive
/// the rows. `translation`: of B in A's frame, in cells.
std::vector<Row> make_rows(BakedObject& a, BakedObject& b, const Point& translation);

}  // namespace flashbvh::bench

#endif
