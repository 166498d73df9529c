// Runs setups of the paper's evaluation and keeps what they gave.
#ifndef FLASHBVH_TOOLS_EVALUATE_RUN_HPP
#define FLASHBVH_TOOLS_EVALUATE_RUN_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/objects.hpp"
#include "evaluate/setups.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh::bench {

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

}  // namespace flashbvh::bench

#endif
