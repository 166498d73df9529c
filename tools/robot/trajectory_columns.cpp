#include "robot/trajectory_columns.hpp"

#include <algorithm>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

const std::string& name_of(const Model& model, std::size_t variable) {
  return model.joints[model.variables[variable]].name;
}

/// The first of them that the line holds; of a file with one column, any.
char separator_of(std::string_view line) {
  for (const char separator : {';', ',', '\t'}) {
    if (line.find(separator) != std::string_view::npos) {
      return separator;
    }
  }
  return ',';
}

/// "time", "t", "Time [s]", "time_from_start", "timestamp", "header.stamp", "secs".
bool names_time(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const std::string first = lower.substr(0, lower.find_first_of(" _[(/"));
  constexpr std::string_view kNames[] = {"t", "sec", "secs", "seconds"};
  return lower.compare(0, 4, "time") == 0 || lower.find("stamp") != std::string::npos ||
         std::find(std::begin(kNames), std::end(kNames), first) != std::end(kNames);
}

TrajectoryColumn column_named(const Model& model, std::string_view name, const std::string& place) {
  const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const ModelJoint& j) { return j.name == name; });
  if (joint != model.joints.end()) {
    return {std::string(name), false, static_cast<std::size_t>(joint - model.joints.begin())};
  }
  if (names_time(name)) {
    return {std::string(name), true, kNoJoint};
  }
  throw UserError(place, "the column ", quoted(name),
                  " is no joint of the robot that moves; its joints are ", variable_names(model));
}

void check_complete(const Model& model, const std::vector<TrajectoryColumn>& columns,
                    const std::string& place) {
  for (std::size_t i = 0; i < model.variables.size(); ++i) {
    if (std::none_of(columns.begin(), columns.end(), [&](const TrajectoryColumn& column) {
          return column.joint == model.variables[i];
        })) {
      throw UserError(place, "has no column ", tool::quoted(name_of(model, i)),
                      "; the first line names all joints that move: ", variable_names(model));
    }
  }
}

}  // namespace

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  const std::string_view blanks = separator == '\t' ? " \v\f" : " \t\v\f";
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
    end = line.find(separator, begin);
    std::string_view field = line.substr(begin, end == std::string_view::npos ? end : end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(blanks), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(blanks) + 1));
  }
  return fields;
}

std::string variable_names(const Model& model) {
  std::string names;
  for (std::size_t i = 0; i < model.variables.size(); ++i) {
    names += (i == 0 ? "" : ",") + name_of(model, i);
  }
  return names;
}

TrajectoryColumns read_columns(const Model& model, std::string_view line,
                               const std::string& place) {
  TrajectoryColumns made = {separator_of(line), {}};
  for (const std::string_view name : fields_of(line, made.separator)) {
    if (std::any_of(made.columns.begin(), made.columns.end(),
                    [&](const TrajectoryColumn& column) { return column.name == name; })) {
      throw UserError(place, "has two columns ", quoted(name), "; leave one out");
    }
    made.columns.push_back(column_named(model, name, place));
  }
  check_complete(model, made.columns, place);
  return made;
}

}  // namespace flashbvh::tool
