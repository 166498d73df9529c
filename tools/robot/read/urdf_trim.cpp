#include "robot/read/urdf_trim.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>

#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {
namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

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
    const bool is_foreign =
        node.ToElement() != nullptr && node.ValueStr().find(':') != std::string::npos;
    dropped = is_foreign ? node.ValueStr() : dropped;
    return is_foreign;
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
  trimmed.has_visual = link.FirstChildElement("visual") != nullptr;
  if (visual_too && link.FirstChildElement("collision") == nullptr) {
    for (TiXmlElement* visual : elements_in(link, "visual")) {
      keep_only(*visual, {"origin", "geometry"});
      visual->SetValue("collision");
    }
  }
  keep_only(link, {"collision"});
  for (TiXmlElement* collision : elements_in(link)) {
    check_geometry(*collision, at_element(path, "link", trimmed.name));
  }
  return trimmed;
}

void check_limits(TiXmlElement& joint, const std::string& type, const std::string& place) {
  TiXmlElement* const limit = joint.FirstChildElement("limit");
  const bool has_range = limit != nullptr && (limit->Attribute("lower") != nullptr ||
                                              limit->Attribute("upper") != nullptr);
  if (type != "continuous" && !has_range) {
    throw UserError(place, "is ", type, " without limits; give it <limit lower=\"...\" upper=\"...",
                    type == "revolute" ? "\">, or make it continuous" : "\">");
  }
  if (limit != nullptr) {  // urdfdom demands forces and speeds; firmware ignores them
    limit->SetAttribute("effort", "0");
    limit->SetAttribute("velocity", "0");
  }
}

SoftLimits soft_limits_of(const TiXmlElement& joint) {
  const TiXmlElement* const soft = joint.FirstChildElement("safety_controller");
  return {parse_number(attribute(soft, "soft_lower_limit")),
          parse_number(attribute(soft, "soft_upper_limit"))};
}

void trim_joint(TiXmlElement& joint, const std::string& path) {
  const std::string place = at_element(path, "joint", attribute(&joint, "name"));
  const std::string type = attribute(&joint, "type");
  if (is_one_of(type, {"floating", "planar"})) {
    throw UserError(place, "is ", type,
                    ", which firmware does not move; make it fixed, or write it as prismatic and "
                    "revolute joints with links without geometry between");
  }
  if (type == "fixed") {
    keep_only(joint, {"origin", "parent", "child"});
    return;
  }
  if (!is_one_of(type, {"revolute", "continuous", "prismatic"})) {
    throw UserError(place, "is of type ", tool::quoted(type),
                    "; use revolute, continuous, prismatic or fixed");
  }
  check_limits(joint, type, place);
  keep_only(joint, {"origin", "parent", "child", "axis", "limit", "mimic"});
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

/// The robot's only floating joint if its parent is a root without shapes, or null.
TiXmlElement* floating_base(TiXmlElement& robot, bool visual_too) {
  TiXmlElement* floating = nullptr;
  std::set<std::string> children;
  for (TiXmlElement* e : elements_in(robot, "joint")) {
    children.insert(attribute(e->FirstChildElement("child"), "link"));
    if (attribute(e, "type") == "floating") {
      if (floating != nullptr) {
        return nullptr;
      }
      floating = e;
    }
  }
  const std::string root =
      floating == nullptr ? "" : attribute(floating->FirstChildElement("parent"), "link");
  for (const TiXmlElement* e : elements_in(robot, "link")) {
    const bool has_shapes = e->FirstChildElement("collision") != nullptr ||
                            (visual_too && e->FirstChildElement("visual") != nullptr);
    if (attribute(e, "name") == root && has_shapes) {
      return nullptr;
    }
  }
  return children.count(root) == 0 ? floating : nullptr;
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
  for (const TiXmlElement* e : elements_in(robot)) {
    if (e->ValueStr().compare(0, 6, "xacro:") == 0) {
      throw UserError(path, "is a xacro (it has <", e->Value(),
                      ">), not yet a URDF; write one with `xacro IN.xacro > OUT.urdf`");
    }
  }
  keep_only(robot, {"link", "joint"});
  normalise_attributes(robot);
  fix_floating_base(robot, visual_too, path, warnings);
  for (TiXmlElement* e : elements_in(robot)) {
    if (e->ValueStr() == "link") {
      trimmed.links.push_back(trim_link(*e, path, visual_too));
    } else {
      trimmed.soft_limits.push_back(soft_limits_of(*e));
      trim_joint(*e, path);
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
