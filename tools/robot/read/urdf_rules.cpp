#include "robot/read/urdf_rules.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// The attributes of an element that has a pose, a size or a limit, and the elements inside that
/// are read, once each.
struct ElementRule {
  std::string_view name;
  std::vector<std::string_view> attributes;
  std::vector<std::string_view> inside = {};
};

const ElementRule kRules[] = {
    {"joint",
     {"name", "type"},
     {"origin", "parent", "child", "axis", "limit", "mimic", "safety_controller"}},
    {"collision", {"name", "group", "concave"}, {"origin", "geometry"}},
    {"geometry", {}, {"box", "sphere", "cylinder", "mesh"}},
    {"origin", {"xyz", "rpy"}},
    {"parent", {"link"}},
    {"child", {"link"}},
    {"axis", {"xyz"}},
    {"limit",
     {"lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk", "damping",
      "friction"}},
    {"mimic", {"joint", "multiplier", "offset"}},
    {"safety_controller",
     {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity", "k_effort"}},
    {"box", {"size"}},
    {"sphere", {"radius"}},
    {"cylinder", {"radius", "length"}},
    {"mesh", {"filename", "scale"}},
};

/// Other programs' elements in a joint or a collision, which move and bound nothing.
bool is_of_other_program(std::string_view name) {
  return is_one_of(name, {"calibration", "color", "contact", "contact_coefficients", "dynamics",
                          "gazebo", "hardwareInterface", "hardware_interface", "joint_properties",
                          "material", "max_contacts", "plugin", "properties", "property", "sensor",
                          "surface", "texture", "transmission", "verbose"});
}

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// True of "0 0.0 -0" and the like.
bool is_zero(const std::string& numbers) {
  return numbers.find_first_not_of("0.+- \t\r\n") == std::string::npos;
}

std::string listed(const std::vector<std::string_view>& names) {
  return joined(names, [](std::string_view name) { return std::string(name); });
}

}  // namespace

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return has(names, name);
}

bool is_foreign(std::string_view name) {
  return name.find(':') != std::string_view::npos;
}

void check_element(const XmlNode& element, const std::string& place) {
  const std::string_view name = element.name;
  const auto rule = std::find_if(std::begin(kRules), std::end(kRules),
                                 [&](const ElementRule& of) { return of.name == name; });
  if (rule == std::end(kRules)) {
    return;
  }
  for (const auto& [attribute, value] : element.attributes) {
    // Some programs write rpy="0 0 0" into each <axis>.
    const bool is_idle = name == "axis" && attribute == "rpy" && is_zero(value);
    if (!has(rule->attributes, attribute) && !is_foreign(attribute) && !is_idle) {
      throw UserError(place, "has <", name, " ", attribute, "=\"", one_line(value),
                      "\">, which URDF does not know; ",
                      rule->attributes.empty() ? "it has no attributes"
                                               : "its attributes are " + listed(rule->attributes));
    }
  }
  if (!element.text.empty() && rule->inside.empty()) {
    throw UserError(place, "has text in its <", name,
                    ">, which URDF does not read; its numbers are ", listed(rule->attributes),
                    ", as attributes");
  }
  std::set<std::string_view> seen;
  for (const XmlNode& inside : element.inside) {
    if (is_foreign(inside.name)) {
      continue;
    }
    if (!has(rule->inside, inside.name)) {
      if (rule->inside.empty() || !is_of_other_program(inside.name)) {
        throw UserError(
            place, "has <", inside.name, "> in <", name, ">, which URDF does not know; ",
            rule->inside.empty() ? "correct it or leave it out"
                                 : "correct it or leave it out: it reads " + listed(rule->inside));
      }
      continue;
    }
    if (!seen.insert(inside.name).second) {
      throw UserError(place, "has two <", inside.name, "> in one <", name,
                      ">; leave one of them out");
    }
    check_element(inside, place);
  }
}

void check_link(const XmlNode& link, const std::string& place) {
  for (const XmlNode& e : link.inside) {
    if (is_one_of(e.name, {"collision", "visual", "inertial"}) || is_foreign(e.name)) {
      continue;
    }
    if (first_in(e, "geometry") != nullptr ||
        is_one_of(e.name, {"geometry", "box", "sphere", "cylinder", "mesh"})) {
      throw UserError(place, "has a shape in <", e.name,
                      ">, which URDF does not know; put it into a <collision>");
    }
    const auto moves = [](const auto& given) { return !is_zero(given.second); };
    if (e.name == "origin" && std::any_of(e.attributes.begin(), e.attributes.end(), moves)) {
      throw UserError(place,
                      "has an <origin> of its own, which moves nothing in URDF; put it into "
                      "its <collision>, or into the joint above");
    }
  }
}

}  // namespace flashbvh::tool
