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

/// What is tested of a pair with a leaf: its box alone, as the paper has it, or its slabs too.
enum class Leaves : std::uint8_t { boxes, shapes };

/// In the tables' order. 16-bit trees where both objects fit, else 32-bit ones. `a` and `b` outlive
/// the rows. `translation`: of B in A's frame, in cells.
std::vector<Row> make_rows(BakedObject& a, BakedObject& b, const Point& translation,
                           Leaves leaves = Leaves::boxes);

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
  std::vector<RowResult> rows;             ///< the paper's: boxes alone
  std::optional<std::uint64_t> best_rule;  ///< absent beyond kBestRuleFaces
  std::vector<RowResult> shaped;           ///< leaves as shapes

  const RowResult& row(const std::string& algorithm) const;
  /// Whether all rows found the same pairs of triangles and, by boxes alone, of leaves, in number.
  bool rows_agree() const;
};

/// Objects up to this size get a row for the best rule.
constexpr std::uint32_t kBestRuleFaces = 3184;

/// In each round each row takes its turn, so that what slows the machine down for a while slows
/// down all of them.
SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects);

// The default tree against the paper's, by visits: how much is won, and how much is left.

/// 0 if the whole is.
inline double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// The visits of one setup, or of several together.
struct DefaultTreeVisits {
  std::uint64_t stackless = 0;  ///< on the paper's tree
  std::uint64_t ranked = 0;     ///< on the default tree
  std::uint64_t best_rule = 0;  ///< on the default tree: the fewest that any rule needs

  double ranked_to_stackless() const { return ratio(ranked, stackless); }
  double ranked_to_best() const { return ratio(ranked, best_rule); }
};

struct DefaultTreeResult {
  const scene::Setup* setup;
  bool intersecting;  ///< whether triangles intersect
  DefaultTreeVisits visits;
};

/// Geometry tests and all. Seconds for the largest setups: the best rule takes the most.
DefaultTreeResult compare_default_tree(const scene::Setup& setup, Objects& objects);

/// The sum over all setups, or over those whose triangles intersect.
DefaultTreeVisits sum_of(const std::vector<DefaultTreeResult>& results, bool only_intersecting);

}  // namespace flashbvh::tool

#endif
