// The paper's evaluation on this machine: all traversals on every setup, with counts and times.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "evaluate/setups.hpp"
#include "flashbvh/query.hpp"

namespace flashbvh::tool {

struct Trees;

/// The trees of the setups' objects, each built once.
class Objects {
 public:
  /// The reference stays valid as long as this object.
  const Trees& get(const scene::PaperObject& object);

 private:
  std::map<std::string, std::shared_ptr<const Trees>> trees_;
};

/// A traversal on one setup: a row of the tables. Leaves reject pairs by their boxes alone.
struct Row {
  std::string name;
  QueryStats counts;
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
  std::uint32_t rounds = 10;        ///< samples; 100 in the paper
};

struct SetupResult {
  const scene::Setup* setup;
  std::uint32_t repetitions;
  std::vector<Row> rows;

  /// True if all rows found the same number of pairs of leaves and of triangles.
  bool rows_agree() const;
};

/// The rows, in the tables' order: all traversals on the paper's tree, then `ranked` on the default
/// tree. Each round runs every row once, so that slowdowns of the machine affect all rows.
SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects);

}  // namespace flashbvh::tool
