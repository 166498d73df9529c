#include "robot/read/foreign.hpp"

#include <set>

#include "robot/read/foreign_reader.hpp"
#include "robot/read/robot_text.hpp"
#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {
namespace {

constexpr ForeignForm kMjcf = {"mujoco", "MJCF", "flashbvh_read_mjcf"};
constexpr ForeignForm kSdf = {"sdf", "SDF", "flashbvh_read_sdf"};

/// UserError if two of the links or joints have one name.
template <class Elements>
void check_names(const Elements& elements, const char* kind, const std::string& path) {
  std::set<std::string> names;
  for (const auto& element : elements) {
    if (!names.insert(element.name).second) {
      throw UserError(at_element(path, kind, element.name), "is there twice; rename one");
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
  check_names(read->robot.links, "link", path);
  check_names(read->robot.joints, "joint", path);
  check_tree(read->robot.links, read->robot.joints, path);
  return std::move(read->robot);
}

}  // namespace flashbvh::tool
