// flashbvh_read_sdf FILE: reads a robot in Gazebo's form, SDF, with libsdformat.
//
// Links of nested models become the model's own, by SDF's names for them, such as arm::hand. SDF's
// poses may be relative to any frame; the reader converts links' poses to the model's frame.
#include <cmath>
#include <filesystem>
#include <map>
#include <sdf/sdf.hh>
#include <set>

#include "readers/reader.hpp"
#include "robot/kinematics.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// SDF writes "no limit" as 10^16, or infinite.
constexpr double kNoLimit = 1e15;

Vector3 vector_of(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}
Transform frame_of(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return transform_of_quaternion({q.W(), q.X(), q.Y(), q.Z()}, vector_of(pose.Pos()));
}

class SdfReader {
 public:
  explicit SdfReader(const std::string& path) : path_(path) {}

  ReadRobot read() {
    sdf::Root root;
    check(root.Load(path_), path_);
    const sdf::Model& model = only_model(root);
    made_.robot.name = model.Name();
    add_links(model, "", {});
    add_joints(model, "");
    made_.robot.root = root_link();
    return std::move(made_);
  }

 private:
  void warn(const std::string& place, const std::string& what) {
    made_.warnings.push_back({place, what});
  }

  void check(const sdf::Errors& errors, const std::string& place) const {
    if (!errors.empty()) {
      throw UserError(place, "is no sound SDF: ", one_line(errors[0].Message()),
                      "; correct what it names");
    }
  }

  Transform resolved(const sdf::SemanticPose& pose, const std::string& place) const {
    ignition::math::Pose3d found;
    check(pose.Resolve(found), place);
    return frame_of(found);
  }

  const sdf::Model& only_model(const sdf::Root& root) const {
    if (root.Model() != nullptr) {
      return *root.Model();
    }
    const bool has_one = root.WorldCount() == 1 && root.WorldByIndex(0)->ModelCount() == 1;
    if (!has_one) {
      throw UserError(path_, "holds no single <model>; name a file of the robot alone");
    }
    return *root.WorldByIndex(0)->ModelByIndex(0);
  }

  /// `frame`: the model's in the outermost model's.
  void add_links(const sdf::Model& model, const std::string& scope, const Transform& frame) {
    if (model.Element() != nullptr) {
      add_file(model.Element()->FilePath());
    }
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      const std::string name = scope + link.Name();
      const std::string place = at_element(path_, "link", name);
      numbers_[name] = made_.robot.links.size();
      frames_.push_back(composed(frame, resolved(link.SemanticPose(), place)));
      UrdfLink& made = made_.robot.links.emplace_back();
      made.name = name;
      for (std::uint64_t j = 0; j < link.CollisionCount(); ++j) {
        add_shape(*link.CollisionByIndex(j), place, made.collisions);
      }
      for (std::uint64_t j = 0; j < link.VisualCount() && made.collisions.empty(); ++j) {
        made.has_visual = true;
        add_shape(*link.VisualByIndex(j), place, made.visuals);
      }
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& nested = *model.ModelByIndex(i);
      const std::string name = scope + nested.Name();
      add_links(nested, name + "::",
                composed(frame, resolved(nested.SemanticPose(), at_element(path_, "model", name))));
    }
  }

  void add_file(const std::string& file) {
    if (!file.empty() && file[0] != '<' && file != path_ && files_.insert(file).second) {
      made_.robot.files.push_back(file);
    }
  }

  template <class Element>
  void add_shape(const Element& element, const std::string& place,
                 std::vector<UrdfCollision>& shapes) {
    UrdfCollision shape;
    shape.origin = resolved(element.SemanticPose(), place);
    if (set_geometry(*element.Geom(), place, shape.geometry)) {
      shapes.push_back(std::move(shape));
    }
  }

  bool set_geometry(const sdf::Geometry& from, const std::string& place, UrdfGeometry& made) {
    using Shape = UrdfGeometry::Shape;
    switch (from.Type()) {
      case sdf::GeometryType::BOX:
        made.shape = Shape::box;
        made.size = vector_of(from.BoxShape()->Size());
        return true;
      case sdf::GeometryType::CYLINDER:
        made.shape = Shape::cylinder;
        made.radius = from.CylinderShape()->Radius();
        made.length = from.CylinderShape()->Length();
        return true;
      case sdf::GeometryType::SPHERE:
        made.shape = Shape::sphere;
        made.radius = from.SphereShape()->Radius();
        return true;
      case sdf::GeometryType::CAPSULE:
        made.shape = Shape::capsule;
        made.radius = from.CapsuleShape()->Radius();
        made.length = from.CapsuleShape()->Length();
        return true;
      case sdf::GeometryType::ELLIPSOID:
        made.shape = Shape::ellipsoid;
        made.size = vector_of(2 * from.EllipsoidShape()->Radii());
        return true;
      case sdf::GeometryType::MESH:
        set_mesh(*from.MeshShape(), place, made);
        return true;
      default:
        warn(place,
             "has a plane, a height map or another shape that is no box, cylinder, sphere, "
             "capsule, ellipsoid or mesh; it is left out; if the robot can hit it, write it "
             "as a box");
        return false;
    }
  }

  /// A path is relative to the file that names it, which may be an included one.
  void set_mesh(const sdf::Mesh& mesh, const std::string& place, UrdfGeometry& made) {
    if (!mesh.Submesh().empty()) {
      throw UserError(place, "has a <submesh> of ", tool::quoted(mesh.Uri()),
                      "; write that part as a mesh file of its own");
    }
    made.shape = UrdfGeometry::Shape::mesh;
    made.size = vector_of(mesh.Scale());
    made.mesh = mesh.Uri();
    const bool is_relative =
        made.mesh.find("://") == std::string::npos && made.mesh.substr(0, 1) != "/";
    const std::filesystem::path file = std::filesystem::absolute(mesh.FilePath());
    if (is_relative && file != std::filesystem::absolute(path_)) {
      made.mesh = "file://" + (file.parent_path() / made.mesh).string();
    }
  }

  void add_joints(const sdf::Model& model, const std::string& scope) {
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
      add_joint(*model.JointByIndex(i), scope);
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      add_joints(*model.ModelByIndex(i), scope + model.ModelByIndex(i)->Name() + "::");
    }
  }

  std::size_t link_number(const std::string& scope, const std::string& name,
                          const std::string& place) {
    if (name == "world" && numbers_.count(scope + name) == 0) {
      if (numbers_.emplace("world", made_.robot.links.size()).second) {
        made_.robot.links.emplace_back().name = "world";
        frames_.emplace_back();
      }
      return numbers_["world"];
    }
    const auto found = numbers_.find(scope + name);
    if (found == numbers_.end()) {
      throw UserError(place, "joins ", tool::quoted(name), ", which is no link of the model");
    }
    return found->second;
  }

  void add_joint(const sdf::Joint& joint, const std::string& scope) {
    const std::string name = scope + joint.Name();
    const std::string place = at_element(path_, "joint", name);
    std::string parent;
    std::string child;
    check(joint.ResolveParentLink(parent), place);
    check(joint.ResolveChildLink(child), place);
    UrdfJoint made;
    made.name = name;
    made.parent = link_number(scope, parent, place);
    made.child = link_number(scope, child, place);
    made.origin = composed(inverse(frames_[made.parent]), frames_[made.child]);
    if (joint.Type() != sdf::JointType::FIXED) {
      ignition::math::Pose3d frame;
      check(joint.SemanticPose().Resolve(frame, child), place);
      made.anchor = vector_of(frame.Pos());
      set_motion(joint, child, place, made);
    }
    made_.robot.joints.push_back(std::move(made));
  }

  void set_motion(const sdf::Joint& joint, const std::string& child, const std::string& place,
                  UrdfJoint& made) {
    using Type = sdf::JointType;
    const bool slides = joint.Type() == Type::PRISMATIC;
    if (!slides && joint.Type() != Type::REVOLUTE && joint.Type() != Type::CONTINUOUS) {
      throw UserError(place, "is ",
                      joint.Type() == Type::BALL ? "a ball" : "neither hinge nor slide",
                      ", which firmware does not move; write it as revolute, continuous, prismatic "
                      "or fixed joints, with links without geometry between");
    }
    const sdf::JointAxis* const axis = joint.Axis();
    if (axis == nullptr) {
      throw UserError(place, "has no <axis>; give it one");
    }
    ignition::math::Vector3d direction;
    check(axis->ResolveXyz(direction, child), place);
    made.axis = vector_of(direction);
    const bool has_lower = std::fabs(axis->Lower()) < kNoLimit;
    const bool has_upper = std::fabs(axis->Upper()) < kNoLimit;
    const bool is_limited = has_lower && has_upper && joint.Type() != Type::CONTINUOUS;
    if (has_lower != has_upper || (slides && !is_limited)) {
      throw UserError(place, slides ? "slides" : "turns",
                      " without two limits; give it <limit> with <lower> and <upper>");
    }
    made.lower = is_limited ? axis->Lower() : 0;
    made.upper = is_limited ? axis->Upper() : 0;
    made.type = slides       ? UrdfJoint::Type::prismatic
                : is_limited ? UrdfJoint::Type::revolute
                             : UrdfJoint::Type::continuous;
    if (axis->Element() != nullptr && axis->Element()->HasElement("mimic")) {
      warn(place,
           "has a <mimic>, which this libsdformat does not read; it does not count: the "
           "joint is taken to move by itself");
    }
  }

  /// The link that is no joint's child.
  std::size_t root_link() const {
    std::set<std::size_t> roots;
    for (std::size_t i = 0; i < made_.robot.links.size(); ++i) {
      roots.insert(i);
    }
    for (const UrdfJoint& joint : made_.robot.joints) {
      roots.erase(joint.child);
    }
    if (roots.size() > 1) {
      throw UserError(at_element(path_, "link", made_.robot.links[*roots.rbegin()].name),
                      "hangs on no joint, as link ",
                      tool::quoted(made_.robot.links[*roots.begin()].name),
                      "; a robot is one tree: join them, or leave one out");
    }
    return roots.empty() ? 0 : *roots.begin();
  }

  const std::string& path_;
  std::map<std::string, std::size_t> numbers_;  ///< of links, by their names
  std::vector<Transform> frames_;               ///< of links, in the model's frame
  std::set<std::string> files_;
  ReadRobot made_;
};

/// Checks for faults at which libsdformat only reports that it can't read the file.
void check_xml(const std::string& path) {
  TiXmlDocument document;
  read_xml(path, "sdf", document);
  if (attribute(document.RootElement(), "version").empty()) {
    throw UserError(path, "has an <sdf> without version; give it one, as in version=\"1.7\"");
  }
}

ReadRobot read_sdf(const std::string& path) {
  check_xml(path);
  return SdfReader(path).read();
}

}  // namespace
}  // namespace flashbvh::tool

int main(int argc, char** argv) {
  flashbvh::tool::run_reader(argc, argv, flashbvh::tool::read_sdf);
}
