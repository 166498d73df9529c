// Reads what this program needs of a URDF, by the format's defaults. Other elements may be faulty.
#include "robot/read/urdf_document.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>

#include "robot/read/urdf_rules.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

template <class Named>
auto find_named(const std::vector<Named>& all, const std::string& name) {
  return std::find_if(all.begin(), all.end(), [&](const Named& e) { return e.name == name; });
}

/// A new name of a link or joint. `known`: those before it.
template <class Named>
std::string new_name(const XmlNode& element, const std::vector<Named>& known,
                     const std::string& path) {
  const std::string name = element.attribute("name");
  if (name.empty() || find_named(known, name) != known.end()) {
    throw UserError(at_element(path, element.name.c_str(), name), "has ",
                    name.empty() ? "no name" : "the name of another",
                    "; give each link and each joint its own");
  }
  return name;
}

/// The attribute's numbers, or `missing` if there is no such element or attribute.
template <std::size_t kCount>
std::array<double, kCount> numbers_in(const XmlNode* element, const char* name,
                                      const std::array<double, kCount>& missing,
                                      const std::string& place) {
  const std::string* const text = element == nullptr ? nullptr : element->find(name);
  if (text == nullptr) {
    return missing;
  }
  const std::vector<std::string_view> words = words_of(*text);
  std::array<double, kCount> numbers{};
  bool are = words.size() == kCount;
  for (std::size_t i = 0; are && i < kCount; ++i) {
    const std::optional<double> number = parse_number(words[i]);
    are = number.has_value();
    numbers[i] = number.value_or(0);
  }
  if (!are) {
    throw UserError(place, "has <", element->name, " ", name, "=\"", one_line(*text), "\">; give ",
                    kCount == 1 ? "a finite number" : "three finite numbers");
  }
  return numbers;
}

double number_in(const XmlNode* element, const char* name, double missing,
                 const std::string& place) {
  return numbers_in<1>(element, name, {missing}, place)[0];
}

/// Rotations about the fixed axes x, y and z, in this order.
Transform origin_in(const XmlNode& element, const std::string& place) {
  const XmlNode* const origin = first_in(element, "origin");
  const auto [roll, pitch, yaw] = numbers_in<3>(origin, "rpy", {}, place);
  const double cx = std::cos(roll / 2), sx = std::sin(roll / 2);
  const double cy = std::cos(pitch / 2), sy = std::sin(pitch / 2);
  const double cz = std::cos(yaw / 2), sz = std::sin(yaw / 2);
  const double x = sx * cy * cz - cx * sy * sz;
  const double y = cx * sy * cz + sx * cy * sz;
  const double z = cx * cy * sz - sx * sy * cz;
  const double w = cx * cy * cz + sx * sy * sz;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  return transform_of_quaternion({w / length, x / length, y / length, z / length},
                                 numbers_in<3>(origin, "xyz", {}, place));
}

/// The only shape of a collision element.
const XmlNode& shape_in(const XmlNode& collision, const std::string& place) {
  std::vector<const XmlNode*> shapes;
  std::string_view foreign;
  if (const XmlNode* const geometry = first_in(collision, "geometry")) {
    for (const XmlNode& e : geometry->inside) {
      if (is_foreign(e.name)) {
        foreign = e.name;
      } else {
        shapes.push_back(&e);
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
  if (shapes[0]->name == "capsule") {
    throw UserError(place,
                    "has a <capsule>, which URDF does not have; write a <collision> with a "
                    "<cylinder> and two with a <sphere>");
  }
  if (!is_one_of(shapes[0]->name, {"box", "cylinder", "sphere", "mesh"})) {
    throw UserError(place, "has a shape <", shapes[0]->name,
                    ">; use <box>, <cylinder>, <sphere> or <mesh>");
  }
  return *shapes[0];
}

UrdfGeometry geometry_of(const XmlNode& shape, const std::string& place) {
  using Shape = UrdfGeometry::Shape;
  // A size that is missing is no positive length, which is refused later.
  if (shape.name == "box") {
    return {Shape::box, numbers_in<3>(&shape, "size", {}, place)};
  }
  if (shape.name == "mesh") {
    return {Shape::mesh, numbers_in<3>(&shape, "scale", {1, 1, 1}, place), 0, 0,
            shape.attribute("filename")};
  }
  const double radius = number_in(&shape, "radius", 0, place);
  if (shape.name == "sphere") {
    return {Shape::sphere, {}, radius};
  }
  return {Shape::cylinder, {}, radius, number_in(&shape, "length", 0, place)};
}

void read_link(const XmlNode& e, const std::string& path, bool visual_too, UrdfRobot& robot) {
  UrdfLink link;
  link.name = new_name(e, robot.links, path);
  const std::string place = at_element(path, "link", link.name);
  check_link(e, place);
  link.has_visual = first_in(e, "visual") != nullptr;
  const bool by_visual = visual_too && first_in(e, "collision") == nullptr;
  for (const XmlNode* const of : elements_in(e, by_visual ? "visual" : "collision")) {
    XmlNode collision = *of;
    collision.name = "collision";
    const XmlNode& shape = shape_in(collision, place);
    check_element(collision, place);
    link.collisions.push_back({origin_in(collision, place), geometry_of(shape, place)});
  }
  robot.links.push_back(std::move(link));
}

/// The number of the link that <parent> or <child> names.
std::size_t link_of(const XmlNode& joint, const char* which, const UrdfRobot& robot,
                    const std::string& place) {
  const std::string name = attribute(first_in(joint, which), "link");
  const auto found = find_named(robot.links, name);
  if (found == robot.links.end()) {
    throw UserError(place, "has the ", which, " ", tool::quoted(name),
                    ", which is no link of the robot; name one that is");
  }
  return static_cast<std::size_t>(found - robot.links.begin());
}

UrdfJoint::Type type_of(const XmlNode& joint, const std::string& place) {
  using Type = UrdfJoint::Type;
  constexpr std::string_view kTypes[] = {"fixed", "revolute", "continuous", "prismatic"};
  const std::string type = joint.attribute("type");
  if (is_one_of(type, {"floating", "planar"})) {
    throw UserError(place, "is ", type,
                    ", which firmware does not move; make it fixed, or write it as prismatic and "
                    "revolute joints with links without geometry between");
  }
  const auto* const found = std::find(std::begin(kTypes), std::end(kTypes), type);
  if (found == std::end(kTypes)) {
    throw UserError(place, "is of type ", tool::quoted(type),
                    "; use revolute, continuous, prismatic or fixed");
  }
  return static_cast<Type>(found - kTypes);
}

/// Soft limits narrow a joint's.
void narrow_limits(const XmlNode& e, const std::string& place, UrdfJoint& joint,
                   Warnings& warnings) {
  const XmlNode* const soft = first_in(e, "safety_controller");
  const double lower =
      std::max(joint.lower, number_in(soft, "soft_lower_limit", joint.lower, place));
  const double upper =
      std::min(joint.upper, number_in(soft, "soft_upper_limit", joint.upper, place));
  if (joint.type == UrdfJoint::Type::continuous || joint.mimic ||
      (lower == joint.lower && upper == joint.upper)) {
    return;
  }
  const std::string ranges =
      concat(shortest(lower), " to ", shortest(upper), ", inside its <limit>, ",
             shortest(joint.lower), " to ", shortest(joint.upper));
  if (lower >= upper) {
    warnings.add(place, concat("has soft limits in its <safety_controller> that leave no range, ",
                               ranges, "; they do not count; correct them"));
    return;
  }
  warnings.add(place, concat("keeps to the soft limits of its <safety_controller>, ", ranges,
                             "; if the machine does not, leave them out"));
  joint.lower = lower;
  joint.upper = upper;
}

void read_limits(const XmlNode& e, const std::string& place, UrdfJoint& joint, Warnings& warnings) {
  const XmlNode* const limit = first_in(e, "limit");
  const auto has = [&](const char* end) { return limit != nullptr && limit->find(end) != nullptr; };
  if (joint.type != UrdfJoint::Type::continuous) {
    if (!has("lower") && !has("upper")) {
      const bool is_revolute = joint.type == UrdfJoint::Type::revolute;
      throw UserError(place, "is ", e.attribute("type"),
                      " without limits; give it <limit lower=\"...\" upper=\"...",
                      is_revolute ? "\">, or make it continuous" : "\">");
    }
    for (const char* const end : {"lower", "upper"}) {
      if (!joint.mimic && !has(end)) {
        warnings.add(place,
                     concat("has a <limit> without ", end, ", which URDF takes for 0; write ", end,
                            "=\"0\" if that is meant"));
      }
    }
  }
  joint.lower = number_in(limit, "lower", 0, place);
  joint.upper = number_in(limit, "upper", 0, place);
  narrow_limits(e, place, joint, warnings);
}

/// `is_base`: it floats and is taken for fixed.
void read_joint(XmlNode e, bool is_base, const std::string& path, UrdfRobot& robot,
                Warnings& warnings) {
  UrdfJoint joint;
  joint.name = new_name(e, robot.joints, path);
  const std::string place = at_element(path, "joint", joint.name);
  if (is_base) {
    warnings.add(place,
                 "floats and is taken for fixed: how the robot's links collide does not depend on "
                 "where it is");
  }
  joint.type = is_base ? UrdfJoint::Type::fixed : type_of(e, place);
  const bool is_fixed = joint.type == UrdfJoint::Type::fixed;
  if (is_fixed) {  // it reads no axis and no limits, correct or not
    const auto moves = [](const XmlNode& inside) {
      return is_one_of(inside.name, {"axis", "limit", "mimic", "safety_controller"});
    };
    e.inside.erase(std::remove_if(e.inside.begin(), e.inside.end(), moves), e.inside.end());
  }
  check_element(e, place);
  joint.parent = link_of(e, "parent", robot, place);
  joint.child = link_of(e, "child", robot, place);
  joint.origin = origin_in(e, place);
  if (const XmlNode* const axis = first_in(e, "axis")) {
    joint.axis = numbers_in<3>(axis, "xyz", {}, place);
  }
  if (const XmlNode* const mimic = first_in(e, "mimic")) {
    joint.mimic = {mimic->attribute("joint"), number_in(mimic, "multiplier", 1, place),
                   number_in(mimic, "offset", 0, place)};
  }
  if (!is_fixed) {
    read_limits(e, place, joint, warnings);
  }
  robot.joints.push_back(std::move(joint));
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

/// The robot's only floating joint if all shapes are below it, or null: how links collide does not
/// depend on the pose of such a base.
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

/// Sets the root. UserError if the joints make no tree of all links.
void find_root(const std::string& path, UrdfRobot& robot) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const auto& [name, root, links, joints] = robot;
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
  const auto first = std::find(above.begin(), above.end(), kNone);
  const auto second = first == above.end() ? first : std::find(first + 1, above.end(), kNone);
  robot.root = static_cast<std::size_t>(first - above.begin());
  if (second != above.end()) {
    throw UserError(at_element(path, "link", links[second - above.begin()].name),
                    "hangs on no joint, nor does ", tool::quoted(links[robot.root].name),
                    "; a robot is a tree: join them");
  }
}

}  // namespace

void check_no_mesh(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  constexpr std::string_view models[] = {".step",   ".stp", ".iges", ".igs", ".brep", ".sldprt",
                                         ".sldasm", ".f3d", ".x_t",  ".stl", ".obj",  ".ply",
                                         ".off",    ".dae", ".gltf", ".glb", ".3mf",  ".fbx"};
  if (std::find(std::begin(models), std::end(models), extension) != std::end(models)) {
    throw UserError(path,
                    "is a mesh or a model of CAD, which has no joints; name a URDF, whose "
                    "links name such meshes, as CAD exports it, or bake it alone by `flashbvh "
                    "bake`");
  }
}

UrdfRobot read_urdf_document(const std::string& path, bool visual_too, Warnings& warnings) {
  const XmlNode document = robot_xml(path);
  const XmlNode* const base = floating_base(document, visual_too);
  UrdfRobot robot;
  robot.name = document.attribute("name");
  if (robot.name.empty() || first_in(document, "link") == nullptr) {
    throw UserError(path, "has a <robot> without ", robot.name.empty() ? "a name" : "links",
                    "; add what it lacks");
  }
  for (const XmlNode* const link : elements_in(document, "link")) {
    read_link(*link, path, visual_too, robot);
  }
  for (const XmlNode* const joint : elements_in(document, "joint")) {
    read_joint(*joint, joint == base, path, robot, warnings);
  }
  find_root(path, robot);
  return robot;
}

}  // namespace flashbvh::tool
