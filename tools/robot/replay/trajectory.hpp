// Joint values over time, as a CSV file has them.
//
// The first line names a variable in each column, in any order; each other line has their values
// one period after the line before: radians, metres of joints that slide. '#' begins a comment.
// Fields lie between semicolons, commas or tabs. Columns of a time and of joints that mimic are
// checked and not used.
#ifndef FLASHBVH_TOOLS_ROBOT_REPLAY_TRAJECTORY_HPP
#define FLASHBVH_TOOLS_ROBOT_REPLAY_TRAJECTORY_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

class Trajectory {
 public:
  explicit Trajectory(std::size_t variables) : variables_(variables) {}

  std::size_t size() const { return lines_.size(); }
  /// Of the file, from 1.
  std::size_t line(std::size_t period) const { return lines_[period]; }
  /// A value a variable, in the order of the model's, as floats: the input of firmware.
  const float* values(std::size_t period) const { return &values_[period * variables_]; }
  std::size_t variables() const { return variables_; }

  void add(std::size_t line, const std::vector<float>& values) {
    lines_.push_back(line);
    values_.insert(values_.end(), values.begin(), values.end());
  }

 private:
  std::size_t variables_;
  std::vector<std::size_t> lines_;
  std::vector<float> values_;
};

/// UserError, with the line and the remedy, unless each variable has one column, all values are
/// numbers, times don't go back, and mimics are where their joints put them. Limits are not looked
/// at. Warns of a column of times, which sets none.
Trajectory read_trajectory(const std::string& path, const Model& model, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
