#include "robot/trajectory.hpp"

#include <algorithm>
#include <string_view>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

/// What is between commas, without the blanks around it.
std::vector<std::string_view> fields_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\v\f";
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
    end = line.find(',', begin);
    std::string_view field = line.substr(begin, end == std::string_view::npos ? end : end - begin);
    field.remove_prefix(std::min(field.find_first_not_of(kBlanks), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(kBlanks) + 1));
  }
  return fields;
}

const std::string& name_of(const Model& model, std::size_t variable) {
  return model.joints[model.variables[variable]].name;
}

std::string names_of(const Model& model) {
  std::string names;
  for (std::size_t i = 0; i < model.variables.size(); ++i) {
    names += (i == 0 ? "" : ",") + name_of(model, i);
  }
  return names;
}

std::size_t variable_named(const Model& model, std::string_view name, const std::string& place) {
  const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                  [&](const ModelJoint& j) { return j.name == name; });
  if (joint == model.joints.end()) {
    throw UserError(place, "the column ", quoted(name),
                    " is no joint of the robot that moves; its joints are ", names_of(model));
  }
  const std::size_t moving = model.variables[joint->variable];
  if (&model.joints[moving] != &*joint) {
    throw UserError(place, "the column ", quoted(name), " is a joint that follows ",
                    tool::quoted(model.joints[moving].name), "; leave it out");
  }
  return joint->variable;
}

/// The variable of each column.
std::vector<std::size_t> read_header(const Model& model, std::string_view line,
                                     const std::string& place) {
  std::vector<std::size_t> variables;
  std::vector<bool> has_column(model.variables.size());
  for (const std::string_view name : fields_of(line)) {
    variables.push_back(variable_named(model, name, place));
    if (has_column[variables.back()]) {
      throw UserError(place, "has two columns ", quoted(name), "; leave one out");
    }
    has_column[variables.back()] = true;
  }
  const auto missing = std::find(has_column.begin(), has_column.end(), false);
  if (missing != has_column.end()) {
    throw UserError(
        place, "has no column ",
        tool::quoted(name_of(model, static_cast<std::size_t>(missing - has_column.begin()))),
        "; the first line names all joints that move: ", names_of(model));
  }
  return variables;
}

std::vector<float> read_values(const std::vector<std::size_t>& variables, std::string_view line,
                               const std::string& place) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != variables.size()) {
    throw UserError(place, "has ", fields.size(), fields.size() == 1 ? " value" : " values",
                    ", the first line names ", variables.size(), " joints; give each one");
  }
  std::vector<float> values(variables.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = parse_number(fields[i]);
    if (!value || !is_coordinate(*value)) {
      throw UserError(place, quoted(fields[i]), " is no finite number; give radians, or metres");
    }
    values[variables[i]] = static_cast<float>(*value);
  }
  return values;
}

}  // namespace

Trajectory read_trajectory(const std::string& path, const Model& model) {
  if (model.variables.empty()) {
    throw UserError(path, "the robot has no joint that moves, so it has no trajectory");
  }
  const std::string text = read_file(path);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const bool is_marked = text.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0;
  Lines lines(std::string_view(text).substr(is_marked ? kByteOrderMark.size() : 0));
  if (!lines.next_content()) {
    throw UserError(path, "has no line that names the joints: ", names_of(model));
  }
  const std::vector<std::size_t> variables =
      read_header(model, lines.line(), at_line(path, lines.number()));
  Trajectory trajectory(model.variables.size());
  while (lines.next_content()) {
    trajectory.add(lines.number(),
                   read_values(variables, lines.line(), at_line(path, lines.number())));
  }
  if (trajectory.size() == 0) {
    throw UserError(path, "has no line of values; give one a period");
  }
  return trajectory;
}

}  // namespace flashbvh::tool
