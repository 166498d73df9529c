// urdfdom, and what it leaves to its caller. It reads on past elements that it can't read and says
// so in its log only; it reads materials, sensors and other elements that nothing here needs, and
// refuses the file for them; and it takes any graph of links with one root for a tree.
//
// Its numbers are those of the C locale, whatever the program's is.
#include "robot/read/urdf_document.hpp"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <set>
#include <string_view>

#include "mesh/mesh_builder.hpp"
#include "robot/read/xml_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Takes out all that is inside `element` but those of these names.
void keep_only(TiXmlElement& element, std::initializer_list<std::string_view> names) {
  for (TiXmlNode* child = element.FirstChild(); child != nullptr;) {
    TiXmlNode* const next = child->NextSibling();
    if (child->ToElement() == nullptr || !is_one_of(child->ValueStr(), names)) {
      element.RemoveChild(child);
    }
    child = next;
  }
}

/// As XML wants attributes (1.0, 3.3.3): each tab and line end a blank. None around them either:
/// urdfdom takes "0.5 " for no number.
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
  for (TiXmlElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    normalise_attributes(*child);
  }
}

/// Whether an element is another program's, as <drake:capsule> is.
bool is_foreign(const TiXmlNode& node) {
  return node.ToElement() != nullptr && node.ValueStr().find(':') != std::string::npos;
}

/// Takes out what is another program's. UserError if nothing else is inside.
void drop_foreign(TiXmlElement& element, const std::string& place) {
  std::string dropped;
  for (TiXmlNode* child = element.FirstChild(); child != nullptr;) {
    TiXmlNode* const next = child->NextSibling();
    if (is_foreign(*child)) {
      dropped = child->ValueStr();
      element.RemoveChild(child);
    }
    child = next;
  }
  if (!dropped.empty() && element.FirstChildElement() == nullptr) {
    throw UserError(place, "has a <collision> whose only shape, <", dropped,
                    ">, is no URDF; use <box>, <cylinder>, <sphere> or <mesh>");
  }
}

/// What urdfdom would skip.
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

/// Makes the <visual> elements of a link <collision> elements.
void collide_by_visuals(TiXmlElement& link) {
  while (TiXmlElement* const visual = link.FirstChildElement("visual")) {
    keep_only(*visual, {"origin", "geometry"});
    visual->SetValue("collision");
  }
}

UrdfLink trim_link(TiXmlElement& link, const std::string& path, bool visual_too) {
  UrdfLink trimmed;
  trimmed.name = attribute(&link, "name");
  trimmed.has_visual = link.FirstChildElement("visual") != nullptr;
  if (visual_too && link.FirstChildElement("collision") == nullptr) {
    collide_by_visuals(link);
  }
  keep_only(link, {"collision"});
  for (TiXmlElement* c = link.FirstChildElement(); c != nullptr; c = c->NextSiblingElement()) {
    check_geometry(*c, at_element(path, "link", trimmed.name));
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
  if (limit != nullptr) {  // Forces and speeds, which urdfdom wants, are nothing to firmware.
    limit->SetAttribute("effort", "0");
    limit->SetAttribute("velocity", "0");
  }
}

/// Of a <safety_controller>: what the machine keeps to.
struct SoftLimits {
  std::optional<double> lower;
  std::optional<double> upper;
};

SoftLimits soft_limits_of(const TiXmlElement& joint) {
  const TiXmlElement* const soft = joint.FirstChildElement("safety_controller");
  return {parse_number(attribute(soft, "soft_lower_limit")),
          parse_number(attribute(soft, "soft_upper_limit"))};
}

void narrow_limits(const SoftLimits& soft, const std::string& path, UrdfJoint& joint,
                   Warnings& warnings) {
  const double lower = std::max(joint.lower, soft.lower.value_or(joint.lower));
  const double upper = std::min(joint.upper, soft.upper.value_or(joint.upper));
  const bool has_limits =
      joint.type == UrdfJoint::Type::revolute || joint.type == UrdfJoint::Type::prismatic;
  if (!has_limits || joint.mimic || (lower == joint.lower && upper == joint.upper)) {
    return;
  }
  const std::string place = at_element(path, "joint", joint.name);
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

/// What the file says, without what is nothing to us.
struct TrimmedRobot {
  std::string text;
  std::vector<UrdfLink> links;          ///< without their collisions
  std::vector<UrdfJoint> joints;        ///< which links they join, no more
  std::vector<SoftLimits> soft_limits;  ///< of each joint
};

using LinkNumbers = std::map<std::string, std::size_t>;

/// Of the link that <parent> or <child> names.
std::size_t link_of(const TiXmlElement& joint, const char* which, const LinkNumbers& links,
                    const std::string& path) {
  const std::string name = attribute(joint.FirstChildElement(which), "link");
  const auto found = links.find(name);
  if (found == links.end()) {
    throw UserError(at_element(path, "joint", attribute(&joint, "name")), "has the ", which, " ",
                    tool::quoted(name), ", which is no link of the robot; name one that is");
  }
  return found->second;
}

void add_joints(const TiXmlElement& robot, const std::string& path, TrimmedRobot& trimmed) {
  LinkNumbers numbers;
  for (std::size_t i = 0; i < trimmed.links.size(); ++i) {
    numbers.emplace(trimmed.links[i].name, i);
  }
  for (const TiXmlElement* e = robot.FirstChildElement("joint"); e != nullptr;
       e = e->NextSiblingElement("joint")) {
    UrdfJoint joint;
    joint.name = attribute(e, "name");
    joint.parent = link_of(*e, "parent", numbers, path);
    joint.child = link_of(*e, "child", numbers, path);
    trimmed.joints.push_back(std::move(joint));
  }
}

/// The only joint of a robot that floats, if it hangs on a root without shapes, or null.
TiXmlElement* floating_base(TiXmlElement& robot, bool visual_too) {
  TiXmlElement* floating = nullptr;
  std::set<std::string> children;
  for (TiXmlElement* e = robot.FirstChildElement("joint"); e != nullptr;
       e = e->NextSiblingElement("joint")) {
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
  for (const TiXmlElement* e = robot.FirstChildElement("link"); e != nullptr;
       e = e->NextSiblingElement("link")) {
    const bool has_shapes = e->FirstChildElement("collision") != nullptr ||
                            (visual_too && e->FirstChildElement("visual") != nullptr);
    if (attribute(e, "name") == root && has_shapes) {
      return nullptr;
    }
  }
  return children.count(root) == 0 ? floating : nullptr;
}

/// Which links of a robot collide does not depend on where it floats.
void fix_floating_base(TiXmlElement& robot, bool visual_too, const std::string& path,
                       Warnings& warnings) {
  if (TiXmlElement* const joint = floating_base(robot, visual_too)) {
    joint->SetAttribute("type", "fixed");
    warnings.add(at_element(path, "joint", attribute(joint, "name")),
                 "floats and is taken for fixed: how the robot's links collide does not depend on "
                 "where it is");
  }
}

TrimmedRobot trim(const std::string& path, std::string text, bool visual_too, Warnings& warnings) {
  TiXmlDocument document;
  parse_xml(std::move(text), path, "robot", document);
  TiXmlElement& robot = *document.RootElement();
  TrimmedRobot trimmed;
  for (const TiXmlElement* e = robot.FirstChildElement(); e != nullptr;
       e = e->NextSiblingElement()) {
    if (e->ValueStr().compare(0, 6, "xacro:") == 0) {
      throw UserError(path, "is a xacro (it has <", e->Value(),
                      ">), not yet a URDF; write one with `xacro IN.xacro > OUT.urdf`");
    }
  }
  keep_only(robot, {"link", "joint"});
  normalise_attributes(robot);
  fix_floating_base(robot, visual_too, path, warnings);
  for (TiXmlElement* e = robot.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (e->ValueStr() == "link") {
      trimmed.links.push_back(trim_link(*e, path, visual_too));
    } else {
      trimmed.soft_limits.push_back(soft_limits_of(*e));
      trim_joint(*e, path);
    }
  }
  add_joints(robot, path, trimmed);
  check_tree(trimmed.links, trimmed.joints, path);  // urdfdom's own model of a loop is never freed
  TiXmlPrinter printer;
  document.Accept(&printer);
  trimmed.text = printer.Str();
  return trimmed;
}

/// urdfdom takes what it says of a text for a format of printf()'s, in which each '%' has to stand
/// twice; so it gets the text, and has its names, like that.
std::string doubled(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result.append(c == '%' ? 2 : 1, c);
  }
  return result;
}
std::string halved(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    i += text.compare(i, 2, "%%") == 0 ? 1 : 0;
  }
  return result;
}

/// Keeps the errors that urdfdom logs, as long as it lives.
class ErrorLog : public console_bridge::OutputHandler {
 public:
  ErrorLog() { console_bridge::useOutputHandler(this); }
  ErrorLog(const ErrorLog&) = delete;
  ErrorLog& operator=(const ErrorLog&) = delete;
  ~ErrorLog() override { console_bridge::restorePreviousOutputHandler(); }

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/,
           int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
      text_ += (text_.empty() ? "" : "; ") + one_line(halved(text));
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

urdf::ModelInterfaceSharedPtr parse(const std::string& text, const std::string& path) {
  const ErrorLog errors;
  urdf::ModelInterfaceSharedPtr model;
  std::string thrown;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    thrown = one_line(halved(error.what()));
  }
  if (model == nullptr || !errors.text().empty()) {
    throw UserError(path, "is no sound URDF: ", errors.text().empty() ? thrown : errors.text(),
                    "; correct what it names");
  }
  return model;
}

Vector3 vector_of(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Transform transform_of(const urdf::Pose& pose) {
  double x = 0, y = 0, z = 0, w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  Transform transform;
  transform.rotation = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                         {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                         {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  transform.translation = vector_of(pose.position);
  return transform;
}

UrdfGeometry geometry_of(const urdf::Geometry& geometry) {
  using Shape = UrdfGeometry::Shape;
  switch (geometry.type) {
    case urdf::Geometry::BOX:
      return {Shape::box, vector_of(static_cast<const urdf::Box&>(geometry).dim), 0, 0, {}};
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      return {Shape::cylinder, {}, cylinder.radius, cylinder.length, {}};
    }
    case urdf::Geometry::SPHERE:
      return {Shape::sphere, {}, static_cast<const urdf::Sphere&>(geometry).radius, 0, {}};
    default: {
      const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
      return {Shape::mesh, vector_of(mesh.scale), 0, 0, halved(mesh.filename)};
    }
  }
}

void set_joint(const urdf::Joint& joint, UrdfJoint& made) {
  using Type = UrdfJoint::Type;
  made.type = joint.type == urdf::Joint::REVOLUTE     ? Type::revolute
              : joint.type == urdf::Joint::CONTINUOUS ? Type::continuous
              : joint.type == urdf::Joint::PRISMATIC  ? Type::prismatic
                                                      : Type::fixed;
  made.origin = transform_of(joint.parent_to_joint_origin_transform);
  made.axis = vector_of(joint.axis);
  if (joint.limits != nullptr) {
    made.lower = joint.limits->lower;
    made.upper = joint.limits->upper;
  }
  if (joint.mimic != nullptr) {
    made.mimic = {halved(joint.mimic->joint_name), joint.mimic->multiplier, joint.mimic->offset};
  }
}

}  // namespace

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

void check_no_mesh(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (is_one_of(extension,
                {".step", ".stp", ".iges", ".igs", ".brep", ".sldprt", ".sldasm", ".f3d", ".x_t",
                 ".stl", ".obj", ".ply", ".off", ".dae", ".gltf", ".glb", ".3mf", ".fbx"})) {
    throw UserError(path,
                    "is a mesh or a model of CAD, which has no joints; name a URDF, whose "
                    "links name such meshes, as CAD exports it, or bake it alone by `flashbvh "
                    "bake`");
  }
}

UrdfRobot read_urdf_document(const std::string& path, std::string text, bool visual_too,
                             Warnings& warnings) {
  TrimmedRobot trimmed = trim(path, std::move(text), visual_too, warnings);
  const urdf::ModelInterfaceSharedPtr model = parse(doubled(trimmed.text), path);
  UrdfRobot robot;
  robot.name = halved(model->getName());
  robot.links = std::move(trimmed.links);
  robot.joints = std::move(trimmed.joints);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    UrdfLink& link = robot.links[i];
    if (doubled(link.name) == model->getRoot()->name) {
      robot.root = i;
    }
    for (const urdf::CollisionSharedPtr& c : model->getLink(doubled(link.name))->collision_array) {
      link.collisions.push_back({transform_of(c->origin), geometry_of(*c->geometry)});
    }
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    UrdfJoint& joint = robot.joints[i];
    set_joint(*model->getJoint(doubled(joint.name)), joint);
    narrow_limits(trimmed.soft_limits[i], path, joint, warnings);
  }
  return robot;
}

}  // namespace flashbvh::tool
