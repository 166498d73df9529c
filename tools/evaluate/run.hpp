// The paper's evaluation on this machine: every order on every setup, its counts, its times, and
// the tables of them as Markdown.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bake/build_tree.hpp"
#include "evaluate/setups.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh::tool {

struct Trees;

/// The trees of the setups' objects, each built once.
class Objects {
 public:
  Objects();
  ~Objects();
  /// The reference stays good as long as this.
  const Trees& get(const scene::PaperObject& object);

 private:
  std::map<std::string, std::unique_ptr<Trees>> trees_;
};

/// What is tested of a pair with a leaf: its box alone, as in the paper, or its planes too. A best
/// rule counts visits and tests no leaf.
enum class Leaves : std::uint8_t { boxes, shapes, none };

/// An order on one setup: a row of the tables.
struct Row {
  std::string name;
  Leaves leaves;
  QueryStats counts;                                           ///< of a best rule, visits alone
  std::vector<double> seconds;                                 ///< a sample each: all repetitions
  std::function<QueryStats(std::uint32_t repetitions)> query;  ///< triangle tests included
};

/// Of all samples of a row, in seconds.
struct Times {
  double least = 0;
  double most = 0;
  double mean = 0;
  double deviation = 0;  ///< the standard deviation
};
Times times_of(const std::vector<double>& samples);

struct Effort {
  double repetitions_scale = 0.01;  ///< of the paper's number; at least one repetition
  std::uint32_t rounds = 10;        ///< samples; the paper's: 100. 0: counts alone
};

struct SetupResult {
  const scene::Setup* setup;
  std::uint32_t repetitions;
  std::vector<Row> rows;

  /// Null if the setup has no such row.
  const Row* row(const std::string& name) const;
  /// Whether all rows found equally many triangle pairs and, by boxes alone, leaf pairs.
  bool rows_agree() const;
};

/// A best rule on the paper's tree is known up to this size: its table of pairs grows.
constexpr std::uint32_t kBestRuleFaces = 3184;

/// The rows, in the tables' order: all orders on the paper's tree with boxes, `best rule`, all
/// orders with leaf planes, and on the default tree `ranked` and the best rule. In each round each
/// row takes its turn, so that what slows the machine down slows down all of them.
SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects);

/// Lines of cells; the first line is the head. The first column is set left, the others right.
std::string markdown_table(const std::vector<std::vector<std::string>>& lines);

/// The heading of one of the paper's tables.
std::string table_heading(std::uint32_t table);

/// A setup's rows, in the paper's columns.
std::string setup_table(const SetupResult& result);

/// All setups side by side: iterations, on the default tree too, overlaps and times. Figure 33
/// plots the lines of table 6.
std::string summary_tables(const std::vector<SetupResult>& results);

/// `translation`: of B in A's frame, in cells. A rule says for each pair of overlapping internal
/// nodes into which tree to descend; at a leaf there is no choice.
/// Time and memory: one table entry for each pair of overlapping nodes of which one is internal.
std::uint64_t best_rule_visits(const bake::BuildTree& a, const bake::BuildTree& b,
                               const Point& translation);

}  // namespace flashbvh::tool
