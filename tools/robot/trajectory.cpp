#include "robot/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "mesh/mesh_builder.hpp"
#include "robot/trajectory_columns.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

/// How far a mimic's value may be from what its joint gives: both have three decimals at least.
constexpr double kMostRounding = 1e-3;

double number_in(std::string_view field, const std::string& place) {
  const auto value = parse_number(field);
  if (value && is_coordinate(*value)) {
    return *value;
  }
  std::string pointed(field);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  if (pointed != field && parse_number(pointed)) {
    throw UserError(place, quoted(field), " has a decimal comma; write a point: ", pointed);
  }
  throw UserError(place, quoted(field), " is no finite number; give radians, or metres");
}

/// The numbers of a line, one a column; none for a time that is no number, as a date.
std::vector<std::optional<double>> numbers_of(const TrajectoryColumns& header,
                                              std::string_view line, const std::string& place) {
  const std::vector<std::string_view> fields = fields_of(line, header.separator);
  if (fields.size() != header.columns.size()) {
    throw UserError(place, "has ", fields.size(), fields.size() == 1 ? " value" : " values",
                    ", the first line names ", header.columns.size(), " columns; give each one");
  }
  std::vector<std::optional<double>> numbers;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    numbers.push_back(header.columns[i].is_time ? parse_number(fields[i])
                                                : number_in(fields[i], place));
  }
  return numbers;
}

/// Of a line; `values`: of the variables.
void check_mimic(const Model& model, const TrajectoryColumn& column, double told,
                 const std::vector<double>& values, const std::string& place) {
  const ModelJoint& joint = model.joints[column.joint];
  const double wanted = joint.multiplier * values[joint.variable] + joint.offset;
  if (std::fabs(told - wanted) > kMostRounding * std::max(1.0, std::fabs(joint.multiplier))) {
    const ModelJoint& master = model.joints[model.variables[joint.variable]];
    throw UserError(place, tool::quoted(joint.name), " is ", significant(told, 6),
                    ", but it follows ", tool::quoted(master.name), ", which puts it at ",
                    significant(wanted, 6), "; leave the column out, or mend the value");
  }
}

/// Reads lines one after the other.
class RowReader {
 public:
  RowReader(const Model& model, TrajectoryColumns columns)
      : model_(model), header_(std::move(columns)), times_(header_.columns.size()) {}

  /// Of the variables, in their order.
  std::vector<float> read(std::string_view line, const std::string& place) {
    const std::vector<std::optional<double>> numbers = numbers_of(header_, line, place);
    check_times(numbers, place);
    std::vector<double> values(model_.variables.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (is_variable(i)) {
        values[model_.joints[header_.columns[i].joint].variable] = *numbers[i];
      }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!header_.columns[i].is_time && !is_variable(i)) {
        check_mimic(model_, header_.columns[i], *numbers[i], values, place);
      }
    }
    return {values.begin(), values.end()};
  }

 private:
  bool is_variable(std::size_t column) const {
    const std::size_t joint = header_.columns[column].joint;
    return joint != kNoJoint && model_.variables[model_.joints[joint].variable] == joint;
  }

  void check_times(const std::vector<std::optional<double>>& numbers, const std::string& place) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!header_.columns[i].is_time || !numbers[i]) {
        continue;
      }
      if (times_[i] && *numbers[i] < *times_[i]) {
        throw UserError(place, tool::quoted(header_.columns[i].name), " goes back from ",
                        shortest(*times_[i]), " to ", shortest(*numbers[i]),
                        "; each line is one period after the line before: sort them");
      }
      times_[i] = numbers[i];
    }
  }

  const Model& model_;
  TrajectoryColumns header_;
  std::vector<std::optional<double>> times_;  ///< the last ones, by column
};

void note_times(const TrajectoryColumns& header, const std::string& place, Warnings& warnings) {
  for (const TrajectoryColumn& column : header.columns) {
    if (column.is_time) {
      warnings.add(place, concat("the column ", tool::quoted(column.name),
                                 " is not used: each line is one period after the line before"));
    }
  }
}

}  // namespace

Trajectory read_trajectory(const std::string& path, const Model& model, Warnings& warnings) {
  if (model.variables.empty()) {
    throw UserError(path, "the robot has no joint that moves, so it has no trajectory");
  }
  const std::string text = read_file(path);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const bool is_marked = text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0;
  Lines lines(std::string_view(text).substr(is_marked ? kByteOrderMark.size() : 0));
  if (!lines.next_content()) {
    throw UserError(path, "has no line that names the joints: ", variable_names(model));
  }
  const std::string place = at_line(path, lines.number());
  TrajectoryColumns columns = read_columns(model, lines.line(), place);
  note_times(columns, place, warnings);
  RowReader reader(model, std::move(columns));
  Trajectory trajectory(model.variables.size());
  while (lines.next_content()) {
    trajectory.add(lines.number(), reader.read(lines.line(), at_line(path, lines.number())));
  }
  if (trajectory.size() == 0) {
    throw UserError(path, "has no line of values; give one a period");
  }
  return trajectory;
}

}  // namespace flashbvh::tool
