#include "robot/read/foreign.hpp"

#include <set>

#include "robot/read/foreign_reader.hpp"
#include "robot/read/robot_text.hpp"
#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {
namespace {

constexpr ForeignForm kMjcf = {"mujoco", "MJCF", "flashbvh_read_mjcf"};
constexpr ForeignForm kSdf = {"sdf", "SDF", "flashbvh_read_sdf"};

/// UserError if two links, or two joints, have one name.
void check_names(const UrdfRobot& robot, const std::string& path) {
  std::set<std::string> links;
  for (const UrdfLink& link : robot.links) {
    if (!links.insert(link.name).second) {
      throw UserError(at_element(path, "link", link.name), "is there twice; rename one");
    }
  }
  std::set<std::string> joints;
  for (const UrdfJoint& joint : robot.joints) {
    if (!joints.insert(joint.name).second) {
      throw UserError(at_element(path, "joint", joint.name), "is there twice; rename one");
    }
  }
}

}  // namespace

bool is_foreign_form(std::string_view root) {
  return root == kMjcf.root || root == kSdf.root;
}

UrdfRobot read_foreign(const std::string& path, std::string_view root, Warnings& warnings) {
  const ForeignForm& form = root == kMjcf.root ? kMjcf : kSdf;
  std::optional<ReadRobot> read = robot_of_text(text_of_reader(form, path));
  if (!read) {
    throw UserError(path, "can't be read: its reader gave no robot", kForeignFix);
  }
  if (const std::size_t colon = read->refusal.find(": "); colon != std::string::npos) {
    throw UserError(read->refusal.substr(0, colon), read->refusal.substr(colon + 2));
  }
  for (const PlacedWarning& warning : read->warnings) {
    warnings.add(warning.place, warning.what);
  }
  read->robot.is_mjcf = root == kMjcf.root;
  check_names(read->robot, path);
  check_tree(read->robot.links, read->robot.joints, path);
  return std::move(read->robot);
}

}  // namespace flashbvh::tool
