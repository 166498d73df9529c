// Reads URDFs with urdfdom, and adds checks. urdfdom skips elements that it can't read and reports
// them in its log only. It refuses files for faults in materials, sensors and other elements that
// are not needed here. It accepts any graph of links with one root as a tree.
//
// urdfdom reads numbers in the C locale, whatever the program's locale is.
#include "robot/read/urdf_document.hpp"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "robot/read/xml_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// urdfdom uses its messages as formats of printf(). So each '%' of its text, and of its names, is
/// doubled.
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

/// Keeps the errors that urdfdom logs during the object's lifetime.
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
  return transform_of_quaternion({w, x, y, z}, vector_of(pose.position));
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

void narrow_limits(const std::string& path, UrdfJoint& joint, Warnings& warnings) {
  const double lower = std::max(joint.lower, joint.soft_lower.value_or(joint.lower));
  const double upper = std::min(joint.upper, joint.soft_upper.value_or(joint.upper));
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
  UrdfRobot robot;
  const std::string text = trimmed_urdf(path, visual_too, robot, warnings);
  const urdf::ModelInterfaceSharedPtr model = parse(doubled(text), path);
  robot.name = halved(model->getName());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    UrdfLink& link = robot.links[i];
    if (doubled(link.name) == model->getRoot()->name) {
      robot.root = i;
    }
    for (const urdf::CollisionSharedPtr& c : model->getLink(doubled(link.name))->collision_array) {
      link.collisions.push_back({transform_of(c->origin), geometry_of(*c->geometry)});
    }
  }
  for (UrdfJoint& joint : robot.joints) {
    set_joint(*model->getJoint(doubled(joint.name)), joint);
    narrow_limits(path, joint, warnings);
  }
  return robot;
}

}  // namespace flashbvh::tool
