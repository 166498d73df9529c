#include "robot/read/urdf_trim.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>

#include "robot/read/urdf_rules.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Removes the nodes inside `element` for which `is_removed` holds.
template <class IsRemoved>
void remove_nodes(TiXmlElement& element, const IsRemoved& is_removed) {
  for (TiXmlNode* child = element.FirstChild(); child != nullptr;) {
    TiXmlNode* const next = child->NextSibling();
    if (is_removed(*child)) {
      element.RemoveChild(child);
    }
    child = next;
  }
}

/// Removes all that is inside `element` but elements of these names.
void keep_only(TiXmlElement& element, std::initializer_list<std::string_view> names) {
  remove_nodes(element, [&](const TiXmlNode& node) {
    return node.ToElement() == nullptr || !is_one_of(node.ValueStr(), names);
  });
}

/// Normalises attributes as XML demands (1.0, 3.3.3): tabs and line ends become blanks. Also trims
/// blanks: urdfdom refuses "0.5 " as a number.
void normalise_attributes(TiXmlElement& element) {
  constexpr const char* kBlanks = " \t\r\n";
  for (TiXmlAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    std::string value = a->ValueStr();
    std::replace_if(
        value.begin(), value.end(), [](char c) { return c == '\t' || c == '\r' || c == '\n'; },
        ' ');
    value.erase(0, value.find_first_not_of(kBlanks));
    value.erase(value.find_last_not_of(kBlanks) + 1);
    a->SetValue(value);
  }
  for (TiXmlElement* child : elements_in(element)) {
    normalise_attributes(*child);
  }
}

/// Removes other programs' elements, such as <drake:capsule>. UserError if nothing else is inside.
void drop_foreign(TiXmlElement& element, const std::string& place) {
  std::string dropped;
  remove_nodes(element, [&](const TiXmlNode& node) {
    const bool is_dropped = node.ToElement() != nullptr && is_foreign(node.ValueStr());
    dropped = is_dropped ? node.ValueStr() : dropped;
    return is_dropped;
  });
  if (!dropped.empty() && element.FirstChildElement() == nullptr) {
    throw UserError(place, "has a <collision> whose only shape, <", dropped,
                    ">, is no URDF; use <box>, <cylinder>, <sphere> or <mesh>");
  }
}

/// UserError for faults that urdfdom would skip.
void check_geometry(TiXmlElement& collision, const std::string& place) {
  TiXmlElement* const geometry = collision.FirstChildElement("geometry");
  if (geometry != nullptr) {
    drop_foreign(*geometry, place);
  }
  const TiXmlElement* const shape = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  if (shape == nullptr || shape->NextSiblingElement() != nullptr) {
    throw UserError(place,
                    "has a <collision> without one shape in its <geometry>; give each "
                    "shape a <collision> of its own");
  }
  if (shape->ValueStr() == "capsule") {
    throw UserError(place,
                    "has a <capsule>, which URDF does not have; write a <collision> with a "
                    "<cylinder> and two with a <sphere>");
  }
  if (!is_one_of(shape->ValueStr(), {"box", "cylinder", "sphere", "mesh"})) {
    throw UserError(place, "has a shape <", shape->Value(),
                    ">; use <box>, <cylinder>, <sphere> or <mesh>");
  }
}

UrdfLink trim_link(TiXmlElement& link, const std::string& path, bool visual_too) {
  UrdfLink trimmed;
  trimmed.name = attribute(&link, "name");
  const std::string place = at_element(path, "link", trimmed.name);
  check_link(link, place);
  trimmed.has_visual = link.FirstChildElement("visual") != nullptr;
  if (visual_too && link.FirstChildElement("collision") == nullptr) {
    for (TiXmlElement* visual : elements_in(link, "visual")) {
      visual->SetValue("collision");
    }
  }
  keep_only(link, {"collision"});
  for (TiXmlElement* collision : elements_in(link)) {
    check_geometry(*collision, place);
    check_element(*collision, place);
  }
  return trimmed;
}

void check_limits(TiXmlElement& joint, const std::string& type, const std::string& place,
                  Warnings& warnings) {
  TiXmlElement* const limit = joint.FirstChildElement("limit");
  const bool has_range = limit != nullptr && (limit->Attribute("lower") != nullptr ||
                                              limit->Attribute("upper") != nullptr);
  if (type != "continuous" && !has_range) {
    throw UserError(place, "is ", type, " without limits; give it <limit lower=\"...\" upper=\"...",
                    type == "revolute" ? "\">, or make it continuous" : "\">");
  }
  for (const char* const end : {"lower", "upper"}) {
    if (type != "continuous" && joint.FirstChildElement("mimic") == nullptr &&
        limit->Attribute(end) == nullptr) {
      warnings.add(place, concat("has a <limit> without ", end, ", which URDF takes for 0; write ",
                                 end, "=\"0\" if that is meant"));
    }
  }
  if (limit != nullptr) {  // urdfdom demands forces and speeds; firmware ignores them
    limit->SetAttribute("effort", "0");
    limit->SetAttribute("velocity", "0");
  }
}

std::optional<double> soft_limit(const TiXmlElement& joint, const char* name,
                                 const std::string& place) {
  const TiXmlElement* const soft = joint.FirstChildElement("safety_controller");
  const std::string text = attribute(soft, name);
  const std::optional<double> limit = parse_number(text);
  if (!limit && soft != nullptr && soft->Attribute(name) != nullptr) {
    throw UserError(place, "has a ", name, " that is no number, ", tool::quoted(one_line(text)),
                    "; give radians or metres");
  }
  return limit;
}

SoftLimits trim_joint(TiXmlElement& joint, const std::string& path, Warnings& warnings) {
  const std::string place = at_element(path, "joint", attribute(&joint, "name"));
  const std::string type = attribute(&joint, "type");
  if (is_one_of(type, {"floating", "planar"})) {
    throw UserError(place, "is ", type,
                    ", which firmware does not move; make it fixed, or write it as prismatic and "
                    "revolute joints with links without geometry between");
  }
  if (type == "fixed") {  // it reads no axis and no limits, correct or not
    remove_nodes(joint, [](const TiXmlNode& node) {
      return is_one_of(node.ValueStr(), {"axis", "limit", "mimic", "safety_controller"});
    });
    check_element(joint, place);
    keep_only(joint, {"origin", "parent", "child"});
    return {};
  }
  if (!is_one_of(type, {"revolute", "continuous", "prismatic"})) {
    throw UserError(place, "is of type ", tool::quoted(type),
                    "; use revolute, continuous, prismatic or fixed");
  }
  check_element(joint, place);
  check_limits(joint, type, place, warnings);
  const SoftLimits soft = {soft_limit(joint, "soft_lower_limit", place),
                           soft_limit(joint, "soft_upper_limit", place)};
  keep_only(joint, {"origin", "parent", "child", "axis", "limit", "mimic"});
  return soft;
}

/// The number of the link that <parent> or <child> names.
std::size_t link_of(const TiXmlElement& joint, const char* which,
                    const std::vector<UrdfLink>& links, const std::string& path) {
  const std::string name = attribute(joint.FirstChildElement(which), "link");
  const auto found = std::find_if(links.begin(), links.end(),
                                  [&](const UrdfLink& link) { return link.name == name; });
  if (found == links.end()) {
    throw UserError(at_element(path, "joint", attribute(&joint, "name")), "has the ", which, " ",
                    tool::quoted(name), ", which is no link of the robot; name one that is");
  }
  return static_cast<std::size_t>(found - links.begin());
}

void add_joints(TiXmlElement& robot, const std::string& path, TrimmedRobot& trimmed) {
  for (const TiXmlElement* e : elements_in(robot, "joint")) {
    UrdfJoint joint;
    joint.name = attribute(e, "name");
    joint.parent = link_of(*e, "parent", trimmed.links, path);
    joint.child = link_of(*e, "child", trimmed.links, path);
    trimmed.joints.push_back(std::move(joint));
  }
}

/// The links below a joint: its child's, and those of all joints that follow.
std::set<std::string> links_below(const TiXmlElement& joint,
                                  const std::vector<TiXmlElement*>& joints) {
  std::set<std::string> below = {attribute(joint.FirstChildElement("child"), "link")};
  for (std::size_t before = 0; before != below.size();) {
    before = below.size();
    for (const TiXmlElement* e : joints) {
      if (below.count(attribute(e->FirstChildElement("parent"), "link")) != 0) {
        below.insert(attribute(e->FirstChildElement("child"), "link"));
      }
    }
  }
  return below;
}

/// The robot's only floating joint if all shapes are below it, or null.
TiXmlElement* floating_base(TiXmlElement& robot, bool visual_too) {
  const std::vector<TiXmlElement*> joints = elements_in(robot, "joint");
  const auto floats = [](const TiXmlElement* e) { return attribute(e, "type") == "floating"; };
  const auto floating = std::find_if(joints.begin(), joints.end(), floats);
  if (std::count_if(joints.begin(), joints.end(), floats) != 1) {
    return nullptr;
  }
  const std::set<std::string> below = links_below(**floating, joints);
  for (const TiXmlElement* e : elements_in(robot, "link")) {
    const bool has_shapes = e->FirstChildElement("collision") != nullptr ||
                            (visual_too && e->FirstChildElement("visual") != nullptr);
    if (has_shapes && below.count(attribute(e, "name")) == 0) {
      return nullptr;
    }
  }
  return *floating;
}

/// Collisions between a robot's links do not depend on the pose of its base.
void fix_floating_base(TiXmlElement& robot, bool visual_too, const std::string& path,
                       Warnings& warnings) {
  if (TiXmlElement* const joint = floating_base(robot, visual_too)) {
    joint->SetAttribute("type", "fixed");
    warnings.add(at_element(path, "joint", attribute(joint, "name")),
                 "floats and is taken for fixed: how the robot's links collide does not depend on "
                 "where it is");
  }
}

}  // namespace

TrimmedRobot trimmed_urdf(const std::string& path, std::string text, bool visual_too,
                          Warnings& warnings) {
  TiXmlDocument document;
  parse_xml(std::move(text), path, "robot", document);
  TiXmlElement& robot = *document.RootElement();
  TrimmedRobot trimmed;
  keep_only(robot, {"link", "joint"});
  normalise_attributes(robot);
  fix_floating_base(robot, visual_too, path, warnings);
  for (TiXmlElement* e : elements_in(robot)) {
    if (e->ValueStr() == "link") {
      trimmed.links.push_back(trim_link(*e, path, visual_too));
    } else {
      trimmed.soft_limits.push_back(trim_joint(*e, path, warnings));
    }
  }
  add_joints(robot, path, trimmed);
  check_tree(trimmed.links, trimmed.joints, path);  // urdfdom never frees its model of a loop
  TiXmlPrinter printer;
  document.Accept(&printer);
  trimmed.text = printer.Str();
  return trimmed;
}

}  // namespace flashbvh::tool
