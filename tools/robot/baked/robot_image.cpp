#include "robot/baked/robot_image.hpp"

#include <cstring>
#include <stdexcept>

#include "flashbvh/detail/robot/distance_table.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/image.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

void add_name(const std::string& name, std::string& names) {
  names += name.substr(0, kMaxRobotNameSize);
  names += '\0';
}

/// The names of the robot, the joints, the links and the mounts.
std::string names_of(const Model& model, const std::string& name) {
  std::string names;
  add_name(name, names);
  for (const ModelJoint& joint : model.joints) {
    add_name(joint.name, names);
  }
  for (const ModelLink& link : model.links) {
    add_name(link.name, names);
  }
  for (const ModelMount& mount : model.mounts) {
    add_name(mount.name, names);
  }
  return names;
}

/// Concatenates parts.
class Bytes {
 public:
  template <class Element>
  void add(const Element* elements, std::size_t count) {
    bytes_.append(reinterpret_cast<const char*>(elements), count * sizeof(Element));
  }
  /// Pads to a whole word.
  void fill() { bytes_.resize((bytes_.size() + 3) / 4 * 4); }
  std::size_t size() const { return bytes_.size(); }
  std::vector<std::uint32_t> words() const {
    std::vector<std::uint32_t> words(bytes_.size() / 4);
    std::memcpy(words.data(), bytes_.data(), bytes_.size());
    return words;
  }

 private:
  std::string bytes_;
};

RobotImageHeader header_of(const Robot& robot) {
  RobotImageHeader header{};
  header.magic = kRobotImageMagic;
  header.version = kRobotImageVersion;
  header.joint_count = robot.joint_count;
  header.link_count = robot.link_count;
  header.hash = robot.hash;
  header.slack = robot.slack;
  std::memcpy(header.cell, &robot.cell_bits, sizeof header.cell);
  header.pair_count = robot.pair_count;
  header.reach_count = robot.reach_count;
  header.variable_count = robot.variable_count;
  header.distance_table_bytes = robot.distance_table_bytes;
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    header.pair_joint_count += robot.pairs[i].joints_a + robot.pairs[i].joints_b;
  }
  return header;
}

std::vector<Mount> fixed_mounts(const Model& model, double cell) {
  std::vector<Mount> mounts(model.mounts.size());
  for (std::size_t i = 0; i < mounts.size(); ++i) {
    const Mount mount = fixed_mount(model.mounts[i], cell);
    std::memset(static_cast<void*>(&mounts[i]), 0, sizeof mount);
    mounts[i].joint = mount.joint;
    mounts[i].frame = mount.frame;
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

std::size_t own_image_bytes(const Model& model, const Robot& robot,
                            const std::vector<UnguardedPair>& unguarded, const std::string& name) {
  std::size_t bytes = sizeof(RobotImageHeader) + robot.joint_count * sizeof(RobotJoint) +
                      robot.link_count * sizeof(RobotLink) + robot.pair_count * sizeof(RobotPair) +
                      robot.reach_count * sizeof(std::uint32_t) +
                      model.mounts.size() * sizeof(Mount) +
                      unguarded.size() * sizeof(RobotUnguarded) + names_of(model, name).size();
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    bytes += distance_table_size(robot, robot.pairs[i]);
  }
  return (bytes + 3) / 4 * 4;
}

std::vector<std::uint32_t> robot_image(const Model& model, const Robot& robot,
                                       const std::vector<UnguardedPair>& unguarded,
                                       const std::vector<std::vector<std::uint32_t>>& meshes,
                                       const std::string& name) {
  check_image(model, name, cell_of(robot));
  RobotImageHeader header = header_of(robot);
  const std::string names = names_of(model, name);
  header.names_size = static_cast<std::uint16_t>(names.size());
  header.unguarded_count = static_cast<std::uint16_t>(unguarded.size());
  const std::vector<Mount> mounts = fixed_mounts(model, cell_of(robot));
  header.mount_count = static_cast<std::uint8_t>(mounts.size());
  Bytes bytes;
  bytes.add(&header, 1);
  bytes.add(robot.joints, robot.joint_count);
  bytes.add(robot.links, robot.link_count);
  bytes.add(robot.pairs, robot.pair_count);
  bytes.add(robot.reaches, robot.reach_count);
  bytes.add(mounts.data(), mounts.size());
  for (const UnguardedPair& pair : unguarded) {
    const RobotUnguarded kept = fixed_unguarded(pair, cell_of(robot));
    bytes.add(&kept, 1);
  }
  bytes.add(robot.distance_tables, robot.distance_table_bytes);
  bytes.add(names.data(), names.size());
  bytes.fill();
  const std::size_t own = bytes.size();
  for (const std::vector<std::uint32_t>& mesh : meshes) {
    bytes.add(mesh.data(), mesh.size());
  }
  if (bytes.size() > UINT32_MAX) {
    throw UserError(model.path, "the image would be over 4 GiB; simplify it: --simplify, --fit");
  }
  std::vector<std::uint32_t> image = bytes.words();
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
