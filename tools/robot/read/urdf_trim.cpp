#include "robot/read/urdf_document.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>

#include "robot/read/urdf_rules.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Names = std::initializer_list<std::string_view>;

std::string tag_of(const XmlNode& element) {
  std::string tag = concat("<", element.name);
  // urdfdom demands forces and speeds; firmware ignores them.
  const bool is_limit = element.name == "limit";
  tag += is_limit ? R"( effort="0" velocity="0")" : "";
  for (const auto& [name, value] : element.attributes) {
    if (!is_limit || !is_one_of(name, {"effort", "velocity"})) {
      tag += concat(" ", name, "=\"", xml_value(value), "\"");
    }
  }
  return tag + ">";
}

/// Appends an element, and those inside at any level that have one of these names.
void print(const XmlNode& element, Names names, std::string& text) {
  text += tag_of(element);
  for (const XmlNode& inside : element.inside) {
    if (is_one_of(inside.name, names)) {
      print(inside, names, text);
    }
  }
  text += concat("</", element.name, ">");
}

/// UserError for faults that urdfdom would skip.
void check_geometry(const XmlNode& collision, const std::string& place) {
  std::vector<std::string_view> shapes;
  std::string_view foreign;
  if (const XmlNode* const geometry = first_in(collision, "geometry")) {
    for (const XmlNode& e : geometry->inside) {
      if (is_foreign(e.name)) {
        foreign = e.name;
      } else {
        shapes.push_back(e.name);
      }
    }
  }
  if (shapes.empty() && !foreign.empty()) {
    throw UserError(place, "has a <collision> whose only shape, <", foreign,
                    ">, is no URDF; use <box>, <cylinder>, <sphere> or <mesh>");
  }
  if (shapes.size() != 1) {
    throw UserError(place,
                    "has a <collision> without one shape in its <geometry>; give each "
                    "shape a <collision> of its own");
  }
  if (shapes[0] == "capsule") {
    throw UserError(place,
                    "has a <capsule>, which URDF does not have; write a <collision> with a "
                    "<cylinder> and two with a <sphere>");
  }
  if (!is_one_of(shapes[0], {"box", "cylinder", "sphere", "mesh"})) {
    throw UserError(place, "has a shape <", shapes[0],
                    ">; use <box>, <cylinder>, <sphere> or <mesh>");
  }
}

/// Appends a link to `text`.
UrdfLink trim_link(XmlNode link, const std::string& path, bool visual_too, std::string& text) {
  UrdfLink trimmed;
  trimmed.name = link.attribute("name");
  const std::string place = at_element(path, "link", trimmed.name);
  check_link(link, place);
  trimmed.has_visual = first_in(link, "visual") != nullptr;
  const bool by_visual = visual_too && first_in(link, "collision") == nullptr;
  for (XmlNode& e : link.inside) {
    e.name = by_visual && e.name == "visual" ? "collision" : e.name;
    if (e.name == "collision") {
      check_geometry(e, place);
      check_element(e, place);
    }
  }
  print(link, {"collision", "origin", "geometry", "box", "cylinder", "sphere", "mesh"}, text);
  return trimmed;
}

void check_limits(const XmlNode& joint, const std::string& type, const std::string& place,
                  Warnings& warnings) {
  const XmlNode* const limit = first_in(joint, "limit");
  const bool has_range =
      limit != nullptr && (limit->find("lower") != nullptr || limit->find("upper") != nullptr);
  if (type != "continuous" && !has_range) {
    throw UserError(place, "is ", type, " without limits; give it <limit lower=\"...\" upper=\"...",
                    type == "revolute" ? "\">, or make it continuous" : "\">");
  }
  for (const char* const end : {"lower", "upper"}) {
    if (type != "continuous" && first_in(joint, "mimic") == nullptr &&
        limit->find(end) == nullptr) {
      warnings.add(place, concat("has a <limit> without ", end, ", which URDF takes for 0; write ",
                                 end, "=\"0\" if that is meant"));
    }
  }
}

std::optional<double> soft_limit(const XmlNode& joint, const char* name, const std::string& place) {
  const XmlNode* const soft = first_in(joint, "safety_controller");
  const std::string text = attribute(soft, name);
  const std::optional<double> limit = parse_number(text);
  if (!limit && soft != nullptr && soft->find(name) != nullptr) {
    throw UserError(place, "has a ", name, " that is no number, ", tool::quoted(one_line(text)),
                    "; give radians or metres");
  }
  return limit;
}

/// The number of the link that <parent> or <child> names.
std::size_t link_of(const XmlNode& joint, const char* which, const std::vector<UrdfLink>& links,
                    const std::string& path) {
  const std::string name = attribute(first_in(joint, which), "link");
  const auto found = std::find_if(links.begin(), links.end(),
                                  [&](const UrdfLink& link) { return link.name == name; });
  if (found == links.end()) {
    throw UserError(at_element(path, "joint", joint.attribute("name")), "has the ", which, " ",
                    tool::quoted(name), ", which is no link of the robot; name one that is");
  }
  return static_cast<std::size_t>(found - links.begin());
}

/// Appends a joint to `text`.
UrdfJoint trim_joint(XmlNode joint, const std::string& path, const std::vector<UrdfLink>& links,
                     Warnings& warnings, std::string& text) {
  const std::string place = at_element(path, "joint", joint.attribute("name"));
  const std::string type = joint.attribute("type");
  if (is_one_of(type, {"floating", "planar"})) {
    throw UserError(place, "is ", type,
                    ", which firmware does not move; make it fixed, or write it as prismatic and "
                    "revolute joints with links without geometry between");
  }
  if (!is_one_of(type, {"revolute", "continuous", "prismatic", "fixed"})) {
    throw UserError(place, "is of type ", tool::quoted(type),
                    "; use revolute, continuous, prismatic or fixed");
  }
  if (type == "fixed") {  // it reads no axis and no limits, correct or not
    const auto moves = [](const XmlNode& e) {
      return is_one_of(e.name, {"axis", "limit", "mimic", "safety_controller"});
    };
    auto& inside = joint.inside;
    inside.erase(std::remove_if(inside.begin(), inside.end(), moves), inside.end());
  }
  check_element(joint, place);
  print(joint, {"origin", "parent", "child", "axis", "limit", "mimic"}, text);
  UrdfJoint trimmed;
  if (type != "fixed") {
    check_limits(joint, type, place, warnings);
    trimmed.soft_lower = soft_limit(joint, "soft_lower_limit", place);
    trimmed.soft_upper = soft_limit(joint, "soft_upper_limit", place);
  }
  trimmed.name = joint.attribute("name");
  trimmed.parent = link_of(joint, "parent", links, path);
  trimmed.child = link_of(joint, "child", links, path);
  return trimmed;
}

/// The links below a joint: its child's, and those of all joints that follow.
std::set<std::string> links_below(const XmlNode& joint, const std::vector<const XmlNode*>& joints) {
  std::set<std::string> below = {attribute(first_in(joint, "child"), "link")};
  for (std::size_t before = 0; before != below.size();) {
    before = below.size();
    for (const XmlNode* e : joints) {
      if (below.count(attribute(first_in(*e, "parent"), "link")) != 0) {
        below.insert(attribute(first_in(*e, "child"), "link"));
      }
    }
  }
  return below;
}

/// The robot's only floating joint if all shapes are below it, or null.
const XmlNode* floating_base(const XmlNode& robot, bool visual_too) {
  const std::vector<const XmlNode*> joints = elements_in(robot, "joint");
  const auto floats = [](const XmlNode* e) { return e->attribute("type") == "floating"; };
  const auto floating = std::find_if(joints.begin(), joints.end(), floats);
  if (std::count_if(joints.begin(), joints.end(), floats) != 1) {
    return nullptr;
  }
  const std::set<std::string> below = links_below(**floating, joints);
  for (const XmlNode* e : elements_in(robot, "link")) {
    const bool has_shapes =
        first_in(*e, "collision") != nullptr || (visual_too && first_in(*e, "visual") != nullptr);
    if (has_shapes && below.count(e->attribute("name")) == 0) {
      return nullptr;
    }
  }
  return *floating;
}

/// Collisions between a robot's links do not depend on the pose of its base.
XmlNode fixed_base(XmlNode joint, const std::string& path, Warnings& warnings) {
  for (auto& [name, value] : joint.attributes) {
    value = name == "type" ? "fixed" : value;
  }
  warnings.add(at_element(path, "joint", joint.attribute("name")),
               "floats and is taken for fixed: how the robot's links collide does not depend on "
               "where it is");
  return joint;
}

/// UserError if a link has two parent joints, or is part of a loop.
void check_tree(const std::vector<UrdfLink>& links, const std::vector<UrdfJoint>& joints,
                const std::string& path) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> above(links.size(), kNone);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    std::size_t& joint = above[joints[i].child];
    if (joint != kNone) {
      throw UserError(at_element(path, "link", links[joints[i].child].name),
                      "is the child of two joints, ", tool::quoted(joints[joint].name), " and ",
                      tool::quoted(joints[i].name), "; a robot is a tree: leave one of them out");
    }
    joint = i;
  }
  for (std::size_t link = 0; link < links.size(); ++link) {
    std::size_t steps = 0;
    for (std::size_t at = link; above[at] != kNone; at = joints[above[at]].parent) {
      if (++steps > links.size()) {
        throw UserError(at_element(path, "link", links[link].name),
                        "hangs on a loop of joints; a robot is a tree: leave out joint ",
                        tool::quoted(joints[above[link]].name));
      }
    }
  }
}

}  // namespace

std::string trimmed_urdf(const std::string& path, bool visual_too, UrdfRobot& robot,
                         Warnings& warnings) {
  const XmlNode document = robot_xml(path);
  const XmlNode* const base = floating_base(document, visual_too);
  std::string text = tag_of(document);
  for (const XmlNode* e : elements_in(document, "link")) {
    robot.links.push_back(trim_link(*e, path, visual_too, text));
  }
  for (const XmlNode* e : elements_in(document, "joint")) {
    robot.joints.push_back(trim_joint(e == base ? fixed_base(*e, path, warnings) : *e, path,
                                      robot.links, warnings, text));
  }
  check_tree(robot.links, robot.joints, path);  // urdfdom never frees its model of a loop
  return text + "</robot>";
}

}  // namespace flashbvh::tool
