// The paper's evaluation on this machine: every order on every setup, with counts, times, and
// tables in Markdown.
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
  /// The reference stays valid as long as this object.
  const Trees& get(const scene::PaperObject& object);

 private:
  std::map<std::string, std::unique_ptr<Trees>> trees_;
};

/// The test of a pair with a leaf: its box alone, as in the paper, or its planes, too. A best rule
/// counts visits and tests no leaf.
enum class Leaves : std::uint8_t { boxes, shapes, none };

/// An order on one setup: a row of the tables.
struct Row {
  std::string name;
  Leaves leaves;
  QueryStats counts;                                           ///< for a best rule, visits only
  std::vector<double> seconds;                                 ///< per sample of all repetitions
  std::function<QueryStats(std::uint32_t repetitions)> query;  ///< includes triangle tests
};

/// Statistics of all samples of a row, in seconds.
struct Times {
  double least = 0;
  double most = 0;
  double mean = 0;
  double deviation = 0;  ///< the standard deviation
};
Times times_of(const std::vector<double>& samples);

struct Effort {
  double repetitions_scale = 0.01;  ///< factor for the paper's number; at least one repetition
  std::uint32_t rounds = 10;        ///< samples; 100 in the paper. 0: counts only
};

struct SetupResult {
  const scene::Setup* setup;
  std::uint32_t repetitions;
  std::vector<Row> rows;

  /// Null if the setup has no such row.
  const Row* row(const std::string& name) const;
  /// True if all rows found the same number of triangle pairs and, with boxes alone, of leaf pairs.
  bool rows_agree() const;
};

/// The largest object with a best rule on the paper's tree: the table of pairs grows with it.
constexpr std::uint32_t kBestRuleFaces = 3184;

/// The rows, in the tables' order: all orders on the paper's tree with boxes, `best rule`, all
/// orders with leaf planes, and `ranked` and the best rule on the default tree. Each round runs
/// every row once, so that slowdowns of the machine affect all rows.
SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects);

/// Lines of cells; the first line is the head. The first column is left-aligned, the others right.
std::string markdown_table(const std::vector<std::vector<std::string>>& lines);

/// The heading of one of the paper's tables.
std::string table_heading(std::uint32_t table);

/// A table of a setup's rows, in the paper's columns.
std::string setup_table(const SetupResult& result);

/// All setups side by side: iterations (also on the default tree), overlaps and times. Figure 33
/// plots the lines of table 6.
std::string summary_tables(const std::vector<SetupResult>& results);

/// `translation`: of B in A's frame, in cells. For each pair of overlapping inner nodes, a rule
/// selects the tree to descend into; at a leaf there is no choice. Time and memory: one table entry
/// for each pair of overlapping nodes of which one is an inner node.
std::uint64_t best_rule_visits(const bake::BuildTree& a, const bake::BuildTree& b,
                               const Point& translation);

}  // namespace flashbvh::tool
