#include "robot/read/joint_limits.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Files are often rounded: a limit up to this much beyond the URDF's counts as equal.
constexpr double kRounding = 1e-4;

std::string yaml_place(const std::string& path, const YAML::Mark& mark) {
  return mark.is_null() ? path : at_line(path, static_cast<std::size_t>(mark.line) + 1);
}

/// A name or value that may hold line ends.
std::string shown(const std::string& text) {
  return tool::quoted(one_line(text));
}

class LimitsReader {
 public:
  LimitsReader(const std::string& path, const std::string& urdf, UrdfRobot& robot,
               Warnings& warnings)
      : path_(path), urdf_(urdf), robot_(robot), warnings_(warnings) {}

  void read(const YAML::Node& root) {
    if (!root.IsMap() || !root["joint_limits"]) {
      throw UserError(path_, "has no `joint_limits:`; name MoveIt's joint_limits.yaml");
    }
    const YAML::Node joints = root["joint_limits"];
    check_map(joints, "joint_limits");
    for (const auto& entry : joints) {
      const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
      check_map(entry.second, name);
      read_joint(name, entry.second);
    }
  }

 private:
  std::string place_of(const YAML::Node& node) const { return yaml_place(path_, node.Mark()); }

  void check_map(const YAML::Node& node, const std::string& name) const {
    if (!node.IsMap()) {
      throw UserError(place_of(node), shown(name),
                      " has no names and values; indent them below it");
    }
  }

  /// Radians or metres.
  std::optional<double> number_of(const YAML::Node& limits, const char* key) const {
    const YAML::Node value = limits[key];
    if (!value) {
      return std::nullopt;
    }
    const bool is_plain = value.IsScalar() && value.Tag().find("degrees") == std::string::npos;
    const std::optional<double> number =
        is_plain ? parse_number(value.Scalar()) : std::optional<double>();
    if (!number) {
      throw UserError(place_of(value), "has a ", key, " that is no number",
                      value.IsScalar() ? ", " + shown(value.Scalar()) : "",
                      "; give radians or metres");
    }
    return number;
  }

  bool are_meant(const YAML::Node& limits) const {
    const YAML::Node value = limits["has_position_limits"];
    bool are_meant = true;
    if (value && !YAML::convert<bool>::decode(value, are_meant)) {
      throw UserError(place_of(value), "has a has_position_limits that is neither true nor false");
    }
    return are_meant;
  }

  void read_joint(const std::string& name, const YAML::Node& limits) {
    const std::optional<double> lower = number_of(limits, "min_position");
    const std::optional<double> upper = number_of(limits, "max_position");
    if (!are_meant(limits) || (!lower && !upper)) {
      return;
    }
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&](const UrdfJoint& of) { return of.name == name; });
    const char* const why = joint == robot_.joints.end()            ? "is no joint of the robot"
                            : joint->type == UrdfJoint::Type::fixed ? "is fixed"
                            : joint->mimic                          ? "mimics another joint"
                            : joint->type == UrdfJoint::Type::continuous
                                ? "is continuous; to limit it, make it revolute in the robot's file"
                                : nullptr;
    if (why != nullptr) {
      warnings_.add(place_of(limits),
                    concat("limits ", shown(name), ", which ", why, "; left out"));
      return;
    }
    narrow(*joint, lower, upper, place_of(limits));
  }

  void narrow(UrdfJoint& joint, const std::optional<double>& lower,
              const std::optional<double>& upper, const std::string& place) const {
    if (lower && *lower < joint.lower - kRounding) {
      refuse_wider(joint, place, "min_position", *lower, "below", joint.lower);
    }
    if (upper && *upper > joint.upper + kRounding) {
      refuse_wider(joint, place, "max_position", *upper, "above", joint.upper);
    }
    const double least = std::max(lower.value_or(joint.lower), joint.lower);
    const double most = std::min(upper.value_or(joint.upper), joint.upper);
    if (least > most) {
      throw UserError(place, "leaves ", shown(joint.name), " no value: from ", shortest(least),
                      " to ", shortest(most), "; correct them");
    }
    joint.lower = least;
    joint.upper = most;
  }

  [[noreturn]] void refuse_wider(const UrdfJoint& joint, const std::string& place, const char* key,
                                 double given, const char* side, double limit) const {
    throw UserError(place, "gives ", shown(joint.name), " a ", key, " of ", shortest(given), ", ",
                    side, " the robot's limit of ", shortest(limit),
                    ", and may only narrow it; give at ", side[0] == 'b' ? "least " : "most ",
                    shortest(limit), ", or change the <limit> in ", urdf_);
  }

  const std::string& path_;
  const std::string& urdf_;
  UrdfRobot& robot_;
  Warnings& warnings_;
};

}  // namespace

void narrow_limits(const std::string& path, const std::string& urdf, UrdfRobot& robot,
                   Warnings& warnings) {
  YAML::Node root;
  try {
    root = YAML::Load(read_file(path));
  } catch (const YAML::Exception& error) {
    throw UserError(yaml_place(path, error.mark), "is no YAML: ", one_line(error.msg),
                    "; correct it there");
  }
  LimitsReader(path, urdf, robot, warnings).read(root);
}

}  // namespace flashbvh::tool
