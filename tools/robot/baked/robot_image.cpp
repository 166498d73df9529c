#include "robot/baked/robot_image.hpp"

#include <cstring>
#include <stdexcept>

#include "flashbvh/detail/robot/distance_table.hpp"
#include "flashbvh/detail/robot/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/image.hpp"
#include "robot/kinematics.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// The names of the robot, the joints, the links and the mounts.
std::string names_of(const Model& model, const std::string& name) {
  std::string names = name.substr(0, kMaxRobotNameSize) + '\0';
  const auto add_all = [&names](const auto& elements) {
    for (const auto& element : elements) {
      names += element.name.substr(0, kMaxRobotNameSize) + '\0';
    }
  };
  add_all(model.joints);
  add_all(model.links);
  add_all(model.mounts);
  return names;
}

template <class Element>
void add(const Element* elements, std::size_t count, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(elements), count * sizeof(Element));
}

/// The header but for the image's size and checksum.
RobotImageHeader header_of(const Model& model, const Robot& robot, std::size_t unguarded,
                           const std::string& names) {
  RobotImageHeader header{};
  header.magic = kRobotImageMagic;
  header.version = kRobotImageVersion;
  header.joint_count = robot.joint_count;
  header.link_count = robot.link_count;
  header.hash = robot.hash;
  header.slack = robot.slack;
  std::memcpy(header.cell, &robot.cell_bits, sizeof header.cell);
  header.pair_joint_count = pair_joint_count(robot);
  header.distance_table_bytes = robot.distance_table_bytes;
  header.pair_count = robot.pair_count;
  header.reach_count = robot.reach_count;
  header.names_size = static_cast<std::uint16_t>(names.size());
  header.variable_count = robot.variable_count;
  header.mount_count = static_cast<std::uint8_t>(model.mounts.size());
  header.unguarded_count = static_cast<std::uint16_t>(unguarded);
  return header;
}

std::vector<Mount> fixed_mounts(const Model& model, double cell) {
  std::vector<Mount> mounts(model.mounts.size());
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    std::memset(static_cast<void*>(&mounts[i]), 0, sizeof mounts[i]);  // padding, too
    mounts[i].joint = fixed_joint(model.mounts[i].joint);
    mounts[i].frame = fixed_frame(model.mounts[i].transform, cell);
  }
  return mounts;
}

}  // namespace

void check_image(const Model& model, const std::string& name, double cell) {
  if (model.mounts.size() > UINT8_MAX) {
    throw UserError(model.path, "has ", model.mounts.size(), " links, an image holds ", UINT8_MAX,
                    "; leave out those without a shape and a tool, or bake it in parts");
  }
  if (const std::size_t size = names_of(model, name).size(); size > UINT16_MAX) {
    throw UserError(model.path, "has names of ", size,
                    " bytes together, an image holds 65,535; shorten them");
  }
  check_limits(model, cell);
}

std::uint32_t pair_joint_count(const Robot& robot) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    count += robot.pairs[i].joints_a + robot.pairs[i].joints_b;
  }
  return count;
}

std::size_t own_image_bytes(const Model& model, const Robot& robot,
                            const std::vector<UnguardedPair>& unguarded, const std::string& name) {
  RobotImageHeader header = header_of(model, robot, unguarded.size(), names_of(model, name));
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    header.distance_table_bytes += distance_table_size(robot, robot.pairs[i]);
  }
  return detail::robot_meshes_offset(header);
}

std::vector<std::uint32_t> robot_image(const Model& model, const Robot& robot,
                                       const std::vector<UnguardedPair>& unguarded,
                                       const std::vector<std::vector<std::uint32_t>>& meshes,
                                       const std::string& name) {
  check_image(model, name, cell_of(robot));
  const std::string names = names_of(model, name);
  RobotImageHeader header = header_of(model, robot, unguarded.size(), names);
  const std::size_t own = detail::robot_meshes_offset(header);
  const std::vector<Mount> mounts = fixed_mounts(model, cell_of(robot));
  std::string bytes;
  add(&header, 1, bytes);
  add(robot.joints, robot.joint_count, bytes);
  add(robot.links, robot.link_count, bytes);
  add(robot.pairs, robot.pair_count, bytes);
  add(robot.reaches, robot.reach_count, bytes);
  add(mounts.data(), mounts.size(), bytes);
  for (const UnguardedPair& pair : unguarded) {
    const RobotUnguarded kept = fixed_unguarded(pair, cell_of(robot));
    add(&kept, 1, bytes);
  }
  add(robot.distance_tables, robot.distance_table_bytes, bytes);
  bytes += names;
  bytes.resize(own);
  for (const std::vector<std::uint32_t>& mesh : meshes) {
    add(mesh.data(), mesh.size(), bytes);
  }
  if (bytes.size() > UINT32_MAX) {
    throw UserError(model.path, "the image would be over 4 GiB; simplify it: --simplify, --fit");
  }
  std::vector<std::uint32_t> image(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(image.data(), bytes.data(), bytes.size());
  header.byte_count = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(image.data(), &header, sizeof header);
  header.crc = image_crc(image.data(), own);
  std::memcpy(image.data(), &header, sizeof header);
  std::vector<Mesh> opened(kMaxLinks);
  Robot again{};
  if (open_robot(image.data(), bytes.size(), opened.data(), kMaxLinks, again) != Status::done) {
    throw std::logic_error("a robot's image that does not open");
  }
  return image;
}

}  // namespace flashbvh::tool
