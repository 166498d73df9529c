// POSIX, and Linux's /proc for where this program is.
#include "robot/read/foreign.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "mesh/guarded_child.hpp"
#include "robot/read/robot_text.hpp"
#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kForeignFix = "; correct it, or convert it to a URDF";

struct Form {
  const char* root;
  const char* name;
  const char* reader;
};
constexpr Form kMjcf = {"mujoco", "MJCF", "flashbvh_read_mjcf"};
constexpr Form kSdf = {"sdf", "SDF", "flashbvh_read_sdf"};

/// Next to this program, as it is built, or in libexec, as it is installed.
std::string reader_of(const Form& form, const std::string& path) {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const fs::path& place : {folder, folder.parent_path() / "libexec/flashbvh"}) {
    if (access((place / form.reader).c_str(), X_OK) == 0) {
      return (place / form.reader).string();
    }
  }
  throw UserError(path, "is ", form.name, ", whose reader is missing: no ", form.reader, " in ",
                  folder.string(), "; install flashbvh again, or convert the file to a URDF");
}

/// Its meshes count, too, and may lie anywhere.
ImportLimits limits_of_robot() {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  return {2048 * kMebibyte, 120};
}

/// Names that a tree of links goes by.
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
  const Form& form = root == kMjcf.root ? kMjcf : kSdf;
  const std::string reader = reader_of(form, path);
  const auto run = [&](int to) {
    dup2(to, STDOUT_FILENO);
    execl(reader.c_str(), reader.c_str(), path.c_str(), nullptr);
    _exit(1);
  };
  const std::string text = guarded_bytes(run, path, limits_of_robot(), kForeignFix);
  std::optional<ReadRobot> read = robot_of_text(text);
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
