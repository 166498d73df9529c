// The checks of a robot, one function per group, and the report of their results.
#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "apart.hpp"
#include "body.hpp"
#include "image.hpp"

namespace robot_check {

class Report {
 public:
  /// Adds a wrong row: its name, both numbers, the consequence.
  void refuse(const std::string& row) { refused_.push_back(row); }
  /// Adds a row that is neither confirmed nor refuted.
  void doubt(const std::string& row) { undecided_.push_back(row); }
  /// Ends a group: prints its line and its rows. Returns false if any was refused.
  bool end(const std::string& group, const std::string& confirmed);
  /// Exit status: 0 all confirmed, 1 refused, 3 undecided.
  int status() const { return any_refused_ ? 1 : any_undecided_ ? 3 : 0; }

 private:
  std::vector<std::string> refused_;
  std::vector<std::string> undecided_;
  bool any_refused_ = false;
  bool any_undecided_ = false;
};

/// The concatenated text of numbers and words.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

/// The margin of the group's tightest row, as text. Infinite: the group has no rows.
std::string nearest_text(double left, const char* unit);

/// Calls `row` with 0 to count - 1, on all processors.
void for_each_row(std::size_t count, const std::function<void(std::size_t)>& row);

/// Limits, mimics, frames, counts, sums, distances, order. If false, no other check can run.
bool check_rules(const Robot& robot, Report& report);
void check_trees(const Robot& robot, Report& report);
void check_spheres(const Robot& robot, Report& report);
void check_slack(const Robot& robot, Report& report);

/// The bodies of all links, in cells, in their joints' frames.
using Bodies = std::vector<Body>;
/// `most_boxes`: the limit of joint boxes per row. The matrix check ends at `end`.
void check_reaches(const Robot& robot, const Bodies& bodies, std::size_t most_boxes,
                   Report& report);
void check_tables(const Robot& robot, const Bodies& bodies, std::size_t most_boxes, Report& report);
void check_matrix(const Robot& robot, const Bodies& bodies, std::size_t most_boxes, Moment end,
                  Report& report);
void check_zones(const Robot& robot, const Bodies& bodies, std::size_t most_boxes, Report& report);

}  // namespace robot_check
