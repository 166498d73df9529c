// Runs setups of the paper's evaluation and keeps what they gave.
#ifndef FLASHBVH_TOOLS_EVALUATE_RUN_HPP
#define FLASHBVH_TOOLS_EVALUATE_RUN_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/objects.hpp"
#include "evaluate/setups.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh::tool {

/// A traversal, ready to run on one setup.
struct Row {
  const char* algorithm;  ///< by its name on the command line
  /// Runs the whole query that many times, geometry tests and all; the counts of the last.
  std::function<Counts(std::uint32_t repetitions)> run;
};

/// In the tables' order. 16-bit trees where both objects fit, else 32-bit ones. `a` and `b` outlive
/// the rows. `translation`: of B in A's frame, in cells.
std::vector<Row> make_rows(BakedObject& a, BakedObject& b, const Point& translation);

struct Effort {
  double repetitions_scale = 0.01;  ///< of the paper's number; at least one repetition
  std::uint32_t rounds = 10;        ///< samples; the paper's: 100
};

/// Of all samples of a row. A sample is the processor time of all repetitions together, in seconds.
struct Times {
  double least = 0;
  double most = 0;
  double mean = 0;
  double deviation = 0;  ///< the standard deviation
};
Times times_of(const std::vector<double>& samples);

struct RowResult {
  std::string algorithm;
  Counts counts;
  Times times;
};

struct SetupResult {
  const scene::Setup* setup;
  std::uint32_t repetitions;
  std::uint32_t rounds;
  std::vector<RowResult> rows;
  std::optional<std::uint64_t> best_rule;  ///< absent beyond kBestRuleFaces

  const RowResult& row(const std::string& algorithm) const;
  /// Whether all rows found the same pairs of leaves and of triangles, in number.
  bool rows_agree() const;
};

/// Objects up to this size get a row for the best rule.
constexpr std::uint32_t kBestRuleFaces = 3184;

/// In each round each row takes its turn, so that what slows the machine down for a while slows
/// down all of them.
SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects);

}  // namespace flashbvh::tool

#endif
