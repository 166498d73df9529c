#include "robot/replay/replay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kPeriod = "each line is one period after the line before";

/// A column of a joint, of the time, or without a name, as of a data frame's index.
struct TrajectoryColumn {
  std::string name;
  std::size_t joint;  ///< of Model::joints; kNoJoint for a time and without a name

  bool has_name() const { return !name.empty(); }
  bool is_joint() const { return joint != kNoJoint; }
  bool is_time() const { return !is_joint() && has_name(); }
};

/// "a,b": the joints that a trajectory must have.
std::string variable_names(const Model& model) {
  return joined(
      model.variables, [&](std::size_t joint) { return model.joints[joint].name; }, ",");
}

/// "time", "t", "Time [s]", "__time", "%time", "time_from_start", "timestamp", "header.stamp",
/// "secs".
bool names_time(std::string_view name) {
  std::string lower = lower_case(name);
  lower.erase(0, lower.find_first_not_of("_%/"));
  const std::string first = lower.substr(0, lower.find_first_of(" _[(/"));
  constexpr std::string_view kNames[] = {"t", "sec", "secs", "seconds"};
  return lower.compare(0, 4, "time") == 0 || lower.find("stamp") != std::string::npos ||
         std::find(std::begin(kNames), std::end(kNames), first) != std::end(kNames);
}

TrajectoryColumn column_named(const Model& model, std::string_view name, const std::string& place) {
  const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const ModelJoint& j) { return j.name == name; });
  if (joint != model.joints.end()) {
    return {std::string(name), static_cast<std::size_t>(joint - model.joints.begin())};
  }
  if (name.empty() || names_time(name)) {
    return {std::string(name), kNoJoint};
  }
  if (parse_number(name)) {
    throw UserError(
        place, "has the value ", quoted(name),
        " in place of a name; put a first line before it that names all joints that move: ",
        variable_names(model));
  }
  throw UserError(place, "the column ", quoted(name),
                  " is no joint of the robot that moves; its joints are ", variable_names(model));
}

void check_complete(const Model& model, const std::vector<TrajectoryColumn>& columns,
                    const std::string& place) {
  for (const std::size_t joint : model.variables) {
    if (std::none_of(columns.begin(), columns.end(),
                     [&](const TrajectoryColumn& column) { return column.joint == joint; })) {
      throw UserError(place, "has no column ", tool::quoted(model.joints[joint].name),
                      "; the first line names all joints that move: ", variable_names(model));
    }
  }
}

/// The fields of a line, without blanks around them.
std::vector<std::string_view> fields_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\v\f";
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
    end = line.find(',', begin);
    std::string_view field = line.substr(begin, end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(kBlanks), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(kBlanks) + 1));
  }
  return fields;
}

/// UserError, with `place`, unless each variable has one column and every other column is a time, a
/// joint that mimics, or without a name.
std::vector<TrajectoryColumn> read_columns(const Model& model, std::string_view line,
                                           const std::string& place) {
  std::vector<TrajectoryColumn> made;
  for (const std::string_view name : fields_of(line)) {
    if (!name.empty() && std::any_of(made.begin(), made.end(), [&](const TrajectoryColumn& column) {
          return column.name == name;
        })) {
      throw UserError(place, "has two columns ", quoted(name), "; leave one out");
    }
    made.push_back(column_named(model, name, place));
  }
  check_complete(model, made, place);
  return made;
}

/// A bound on a mimic's difference from its joint's value: both have three decimals at least.
constexpr double kMostRounding = 1e-3;

double number_in(std::string_view field, const std::string& column, const std::string& place) {
  const auto value = parse_number(field);
  if (value && is_coordinate(*value)) {
    return *value;
  }
  throw UserError(place, quoted(field), " in the column ", tool::quoted(column),
                  " is no finite number; give radians, or metres");
}

/// The numbers of a line, one per column; none for a time that is no number, such as a date.
std::vector<std::optional<double>> numbers_of(const std::vector<TrajectoryColumn>& columns,
                                              std::string_view line, const std::string& place) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != columns.size()) {
    throw UserError(place, "has ", fields.size(), fields.size() == 1 ? " value" : " values",
                    ", the first line names ", columns.size(), " columns; give each one");
  }
  std::vector<std::optional<double>> numbers;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const TrajectoryColumn& column = columns[i];
    numbers.push_back(column.is_joint() ? number_in(fields[i], column.name, place)
                                        : parse_number(fields[i]));
  }
  return numbers;
}

/// Checks a mimic in a line. `values`: of the variables.
void check_mimic(const Model& model, const TrajectoryColumn& column, double given,
                 const std::vector<double>& values, const std::string& place) {
  const ModelJoint& joint = model.joints[column.joint];
  const double wanted = joint.multiplier * values[joint.variable] + joint.offset;
  if (std::fabs(given - wanted) > kMostRounding * std::max(1.0, std::fabs(joint.multiplier))) {
    const ModelJoint& master = model.joints[model.variables[joint.variable]];
    throw UserError(place, tool::quoted(joint.name), " is ", significant(given, 6),
                    ", but it follows ", tool::quoted(master.name), ", which puts it at ",
                    significant(wanted, 6), "; leave the column out, or correct the value");
  }
}

/// Reads lines one after the other.
class RowReader {
 public:
  RowReader(const Model& model, std::vector<TrajectoryColumn> columns)
      : model_(model), columns_(std::move(columns)), last_(columns_.size()) {
    while (times_in_ < last_.size() && !columns_[times_in_].is_time()) {
      ++times_in_;
    }
  }

  /// Adds a period.
  void read(std::string_view line, const std::string& place, Trajectory& trajectory) {
    const std::vector<std::optional<double>> numbers = numbers_of(columns_, line, place);
    check_times(numbers, place);
    if (times_in_ < numbers.size() && numbers[times_in_]) {
      trajectory.time_name = columns_[times_in_].name;
      trajectory.times.push_back(*numbers[times_in_]);
    } else {
      times_in_ = numbers.size();  // for example a date
      trajectory.times.clear();
    }
    std::vector<double> values(model_.variables.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const TrajectoryColumn& column = columns_[i];
      if (column.is_joint() && !is_mimic(model_, column.joint)) {
        values[model_.joints[column.joint].variable] = *numbers[i];
      }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (columns_[i].is_joint() && is_mimic(model_, columns_[i].joint)) {
        check_mimic(model_, columns_[i], *numbers[i], values, place);
      }
    }
    trajectory.all_values.insert(trajectory.all_values.end(), values.begin(), values.end());
  }

  /// Warns of columns of times that name no line.
  void warn_of_unused_times(const std::string& path, Warnings& warnings) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].is_time() && i != times_in_) {
        warnings.add(
            path, concat("the column ", tool::quoted(columns_[i].name), " is not used: ", kPeriod));
      }
    }
  }

 private:
  void check_times(const std::vector<std::optional<double>>& numbers, const std::string& place) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!columns_[i].is_time() || !numbers[i]) {
        continue;
      }
      if (last_[i] && *numbers[i] < *last_[i]) {
        throw UserError(place, tool::quoted(columns_[i].name), " goes back from ",
                        shortest(*last_[i]), " to ", shortest(*numbers[i]), "; ", kPeriod,
                        ": sort them");
      }
      last_[i] = numbers[i];
    }
  }

  const Model& model_;
  std::vector<TrajectoryColumn> columns_;
  std::vector<std::optional<double>> last_;  ///< last times, by column
  std::size_t times_in_ = 0;  ///< the column that names lines; if none, the number of columns
};

/// Steps of times are uneven if they differ from the first one by more than this part of it.
constexpr double kMostUneven = 0.1;

/// Warns of the first uneven step of times.
void warn_of_uneven_times(const std::string& path, const Trajectory& trajectory,
                          Warnings& warnings) {
  for (std::size_t i = 2; i < trajectory.times.size(); ++i) {
    const double first = trajectory.times[1] - trajectory.times[0];
    const double step = trajectory.times[i] - trajectory.times[i - 1];
    // Large stamps have fewer digits than their steps.
    if (std::fabs(step - first) > kMostUneven * first + 1e-15 * std::fabs(trajectory.times[i])) {
      warnings.add(at_line(path, trajectory.lines[i]),
                   concat(tool::quoted(trajectory.time_name), " steps by ", significant(step, 6),
                          ", the first time by ", significant(first, 6), "; ", kPeriod));
      return;
    }
  }
}

}  // namespace

Trajectory read_trajectory(const std::string& path, const Model& model, Warnings& warnings) {
  const std::string text = read_file(path);
  refuse_other_contents(text, path);
  Lines lines(without_padding(text));
  if (!lines.next_content()) {
    throw UserError(path, "has no line that names the joints: ", variable_names(model));
  }
  const std::string place = at_line(path, lines.number());
  RowReader reader(model, read_columns(model, lines.line(), place));
  Trajectory trajectory = {model.variables.size()};
  while (lines.next_content()) {
    trajectory.lines.push_back(lines.number());
    reader.read(lines.line(), at_line(path, lines.number()), trajectory);
  }
  if (trajectory.size() == 0) {
    throw UserError(path, "has no line of values; give one a period");
  }
  reader.warn_of_unused_times(path, warnings);
  warn_of_uneven_times(path, trajectory, warnings);
  return trajectory;
}

}  // namespace flashbvh::tool
