#include "robot/baked/robot_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/image_file.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/kinematics.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

ModelJoint model_joint(const RobotJoint& fixed, double cell) {
  const double unit = unit_of_coordinate(fixed.type, cell);
  ModelJoint joint;
  joint.parent = joint_of(fixed.parent);
  joint.fixed = transform_of(fixed.fixed, cell);
  joint.type = fixed.type;
  joint.lower = fixed.type == JointType::continuous ? -kPi : fixed.lower * unit;
  joint.upper = fixed.type == JointType::continuous ? kPi : fixed.upper * unit;
  joint.variable = fixed.variable;
  return joint;
}

}  // namespace

bool is_robot_file_name(const std::string& path) {
  const std::string extension = ".robot";
  return path.size() > extension.size() &&
         path.compare(path.size() - extension.size(), extension.size(), extension) == 0;
}

RobotFile::RobotFile(const std::string& path) : RobotFile(path, read_file(path)) {}

RobotFile::RobotFile(const std::string& path, const std::string& bytes)
    : path_(path), words_((bytes.size() + 3) / 4), meshes_(kMaxLinks) {
  std::memcpy(words_.data(), bytes.data(), bytes.size());
  // Only for messages: the library validates.
  std::memcpy(&header_, bytes.data(), std::min(bytes.size(), sizeof header_));
  const Status status = open_robot(words_.data(), bytes.size(), meshes_.data(), kMaxLinks, robot_);
  check_opened(status, path, bytes.size(),
               {sizeof header_, header_.byte_count, header_.version, kRobotImageVersion,
                "is no image of a robot; name one that `flashbvh robot --format image` wrote"});
}

Model RobotFile::model() const {
  Model model;
  model.name = name();
  model.path = path_;
  model.variables.resize(robot_.variable_count);
  for (std::uint32_t i = 0; i < robot_.joint_count; ++i) {
    const RobotJoint& fixed = robot_.joints[i];
    ModelJoint joint = model_joint(fixed, cell());
    joint.name = flashbvh::joint_name(words_.data(), i);
    if (fixed.shift == 0) {
      model.variables[fixed.variable] = i;
    }
    model.joints.push_back(joint);
  }
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    ModelJoint& joint = model.joints[i];
    const RobotJoint& fixed = robot_.joints[i];
    const ModelJoint& master = model.joints[model.variables[joint.variable]];
    const double unit = unit_of_coordinate(joint.type, cell());
    joint.multiplier =
        std::ldexp(fixed.multiplier, -fixed.shift) * unit / unit_of_coordinate(master.type, cell());
    joint.offset = fixed.offset * unit;
  }
  for (std::uint32_t i = 0; i < robot_.link_count; ++i) {
    ModelLink link;
    link.name = link_name(words_.data(), i);
    link.joint = joint_of(robot_.links[i].joint);
    model.part_count += find_link(model, link.name) != kNoLink ? 1 : 0;
    model.links.push_back(link);
  }
  for (std::uint32_t i = 0; i < mount_count(words_.data()); ++i) {
    const Mount& mount = mounts(words_.data())[i];
    model.mounts.push_back(
        {mount_name(words_.data(), i), joint_of(mount.joint), transform_of(mount.frame, cell())});
  }
  return model;
}

std::vector<UnguardedPair> RobotFile::unguarded() const {
  std::vector<UnguardedPair> unguarded;
  const RobotUnguarded* const kept = flashbvh::unguarded_pairs(words_.data());
  // Parts outside a zone are links with the names of their links.
  const auto is_of = [&](std::uint8_t part, std::uint8_t link) {
    return std::strcmp(link_name(words_.data(), part), link_name(words_.data(), link)) == 0;
  };
  for (std::uint32_t i = 0; i < unguarded_count(words_.data()); ++i) {
    const RobotUnguarded& of = kept[i];
    const bool is_guarded =
        std::any_of(robot_.pairs, robot_.pairs + robot_.pair_count, [&](const RobotPair& pair) {
          return (is_of(pair.a, of.a) && is_of(pair.b, of.b)) ||
                 (is_of(pair.a, of.b) && is_of(pair.b, of.a));
        });
    unguarded.push_back(unguarded_pair(of, cell(), of.why == WhyUnguarded::zone && !is_guarded));
  }
  return unguarded;
}

}  // namespace flashbvh::tool
