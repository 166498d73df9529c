// The first line of a trajectory's CSV file: which column holds what.
#ifndef FLASHBVH_TOOLS_ROBOT_TRAJECTORY_COLUMNS_HPP
#define FLASHBVH_TOOLS_ROBOT_TRAJECTORY_COLUMNS_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robot/model.hpp"

namespace flashbvh::tool {

/// A column of a joint, or of the time.
struct TrajectoryColumn {
  std::string name;
  bool is_time = false;
  std::size_t joint = kNoJoint;  ///< of Model::joints; none: the time's
};

struct TrajectoryColumns {
  char separator;  ///< of the fields in each line: a semicolon, a comma or a tab
  std::vector<TrajectoryColumn> columns;
};

/// The fields of a line, without the blanks around them.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// "a,b": the joints that a trajectory must have.
std::string variable_names(const Model& model);

/// UserError, with `place`, unless each variable has one column and every other column is a time or
/// a joint that mimics.
TrajectoryColumns read_columns(const Model& model, std::string_view line, const std::string& place);

}  // namespace flashbvh::tool

#endif
