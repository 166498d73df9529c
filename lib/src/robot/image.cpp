#include "flashbvh/robot/image.hpp"

#include <string.h>

#include "../lattice/vertex_rounding.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/detail/robot/image_parts.hpp"
#include "hash.hpp"

namespace flashbvh {

using namespace detail;

namespace {

static_assert(offsetof(RobotImageHeader, byte_count) == offsetof(ImageHeader, byte_count) &&
                  offsetof(RobotImageHeader, crc) == offsetof(ImageHeader, crc),
              "image_crc() leaves these bytes out");

/// Slack for rounding vertices alone, in 1/256 cell (lib/docs/derivations.md, "Robots").
constexpr uint32_t kLeastSlack = detail::kVertexRounding;

const RobotImageHeader& header_of(const void* image) {
  return *image_part<RobotImageHeader>(image, 0);
}

/// More than any robot has; clamps a header's value, so that offsets fit 32 bits.
constexpr uint32_t kMostTableBytes = 1u << 28;

uint32_t mounts_offset(const RobotImageHeader& header) {
  return static_cast<uint32_t>(sizeof header + header.joint_count * sizeof(RobotJoint) +
                               header.link_count * sizeof(RobotLink) +
                               header.pair_count * sizeof(RobotPair) +
                               header.reach_count * sizeof(uint32_t));
}

uint32_t unguarded_offset(const RobotImageHeader& header) {
  return mounts_offset(header) + static_cast<uint32_t>(header.mount_count * sizeof(Mount));
}

uint32_t distance_tables_offset(const RobotImageHeader& header) {
  return unguarded_offset(header) +
         static_cast<uint32_t>(header.unguarded_count * sizeof(RobotUnguarded));
}

uint32_t names_offset(const RobotImageHeader& header) {
  return distance_tables_offset(header) + (header.distance_table_bytes < kMostTableBytes
                                               ? header.distance_table_bytes
                                               : kMostTableBytes);
}

bool counts_fit(const RobotImageHeader& header) {
  return header.joint_count >= 1 && header.joint_count <= kMaxJoints && header.link_count >= 1 &&
         header.variable_count <= header.joint_count && header.slack >= kLeastSlack &&
         header.slack <= kMaxGuardDistance && header.padding == 0;
}

/// Checks the number and the lengths of names, and that zeros follow up to the meshes.
[[gnu::noinline]] bool names_fit(const void* bytes, const RobotImageHeader& header) {
  const char* const names = image_part<char>(bytes, names_offset(header));
  const uint32_t count = 1u + header.joint_count + header.link_count + header.mount_count;
  uint32_t ended = 0;
  uint32_t length = 0;
  for (uint32_t i = 0; i < header.names_size; ++i) {
    length = names[i] == 0 ? 0 : length + 1;
    ended += names[i] == 0 ? 1 : 0;
    if (length > kMaxRobotNameSize) {
      return false;
    }
  }
  bool is_gap_zero = true;
  for (uint32_t i = header.names_size;
       names + i < image_part<char>(bytes, robot_meshes_offset(header)); ++i) {
    is_gap_zero = is_gap_zero && names[i] == 0;
  }
  return ended == count && length == 0 && is_gap_zero;
}

/// Checks mounts, but not their frames, which are checked where they are used.
bool mounts_fit(const void* bytes, const RobotImageHeader& header) {
  const Mount* const mounts = image_part<Mount>(bytes, mounts_offset(header));
  for (uint32_t i = 0; i < header.mount_count; ++i) {
    const unsigned char* const padding = &mounts[i].joint + 1;
    if ((mounts[i].joint >= header.joint_count && mounts[i].joint != kBase) ||
        (padding[0] | padding[1] | padding[2]) != 0) {
      return false;
    }
  }
  return true;
}

uint32_t links_of(uint32_t a, uint32_t b) {
  return a << 8 | b;
}

/// Returns whether a joint is the only one between two links.
bool is_joint_between(const Robot& robot, uint32_t joint, uint32_t a, uint32_t b) {
  const uint32_t joint_a = robot.links[a].joint;
  const uint32_t joint_b = robot.links[b].joint;
  return joint < robot.joint_count &&
         ((joint == joint_a && robot.joints[joint].parent == joint_b) ||
          (joint == joint_b && robot.joints[joint].parent == joint_a));
}

/// Checks that a zone has a joint and a radius, and any other pair has none.
bool zone_fits(const Robot& robot, const RobotUnguarded& pair) {
  return pair.why == WhyUnguarded::zone
             ? pair.radius != 0 && is_joint_between(robot, pair.joint, pair.a, pair.b)
             : pair.why == WhyUnguarded::believed && pair.radius == 0 && pair.joint == kBase;
}

/// Checks that unguarded pairs ascend, are not guarded, and that a joint moves their links.
[[gnu::noinline]] bool unguarded_fit(const void* bytes, const Robot& robot) {
  const uint32_t count = header_of(bytes).unguarded_count;
  const RobotUnguarded* const unguarded = unguarded_pairs(bytes);
  uint32_t before = 0;
  const RobotPair* guarded = robot.pairs;
  for (uint32_t i = 0; i < count; ++i) {
    const RobotUnguarded& pair = unguarded[i];
    const uint32_t links = links_of(pair.a, pair.b);
    while (guarded != robot.pairs + robot.pair_count && links_of(guarded->a, guarded->b) < links) {
      ++guarded;
    }
    const bool is_guarded =
        guarded != robot.pairs + robot.pair_count && links_of(guarded->a, guarded->b) == links;
    if (pair.a >= pair.b || pair.b >= robot.link_count || links <= before || is_guarded ||
        robot.links[pair.a].joint == robot.links[pair.b].joint || !zone_fits(robot, pair)) {
      return false;
    }
    before = links;
  }
  return true;
}

[[gnu::noinline]] void view(const void* bytes, const Mesh* meshes, Robot& robot) {
  const RobotImageHeader& header = header_of(bytes);
  robot.joints = image_part<RobotJoint>(bytes, sizeof header);
  robot.links = reinterpret_cast<const RobotLink*>(robot.joints + header.joint_count);
  robot.meshes = meshes;
  robot.pairs = reinterpret_cast<const RobotPair*>(robot.links + header.link_count);
  robot.reaches = reinterpret_cast<const uint32_t*>(robot.pairs + header.pair_count);
  robot.distance_tables = image_part<uint8_t>(bytes, distance_tables_offset(header));
  robot.joint_count = header.joint_count;
  robot.link_count = header.link_count;
  robot.variable_count = header.variable_count;
  robot.padding = 0;
  robot.pair_count = header.pair_count;
  robot.reach_count = header.reach_count;
  robot.slack = header.slack;
  robot.distance_table_bytes = header.distance_table_bytes;
  robot.hash = header.hash;
  robot.cell_bits = (uint64_t{header.cell[1]} << 32) | header.cell[0];
}

/// Checks alignment and header; its copy is gone from the stack when meshes are opened.
[[gnu::noinline]] Status check_robot_readable(const void* bytes, size_t size) {
  RobotImageHeader copy;
  return reinterpret_cast<uintptr_t>(bytes) % 4 != 0 ? Status::image_misaligned
                                                     : read_robot_image_header(bytes, size, copy);
}

/// Opens all meshes, which must fill the image to its end.
[[gnu::noinline]] Status open_meshes(const void* bytes, Mesh* meshes, uint64_t cell_bits) {
  const RobotImageHeader& header = header_of(bytes);
  uint32_t offset = robot_meshes_offset(header);
  for (uint32_t i = 0; i < header.link_count; ++i) {
    const void* const image = image_part<unsigned char>(bytes, offset);
    const Status status = open_image(image, header.byte_count - offset, meshes[i]);
    if (status == Status::image_truncated || status == Status::image_not_flashbvh) {
      return Status::image_corrupt;  // not truncated: the robot's bytes are complete
    }
    if (status != Status::done) {
      return status;
    }
    if (meshes[i].cell_bits != cell_bits || meshes[i].unit != Unit::m) {
      return Status::cell_mismatch;
    }
    offset += image_part<ImageHeader>(image, 0)->byte_count;
  }
  return offset == header.byte_count ? Status::done : Status::image_invalid;
}

const char* name_of(const void* image, uint32_t number) {
  const char* name = image_part<char>(image, names_offset(header_of(image)));
  while (number != 0) {
    number -= *name++ == 0 ? 1u : 0u;
  }
  return name;
}

}  // namespace

namespace detail {

uint32_t robot_meshes_offset(const RobotImageHeader& header) {
  return (names_offset(header) + header.names_size + 3) & ~3u;
}

Status open_robot_unhashed(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                           Robot& robot) {
  const Status read = check_robot_readable(bytes, size);
  if (read != Status::done) {
    return read;
  }
  const RobotImageHeader& header = header_of(bytes);
  const uint32_t own = robot_meshes_offset(header);
  if (header.byte_count < own || image_crc(bytes, own) != header.crc) {
    return Status::image_corrupt;
  }
  view(bytes, meshes, robot);
  uint32_t pair_joint_count = 0;
  if (!counts_fit(header) || !names_fit(bytes, header) || !mounts_fit(bytes, header) ||
      !check_robot(robot, pair_joint_count) || pair_joint_count != header.pair_joint_count ||
      !unguarded_fit(bytes, robot)) {
    return Status::image_invalid;
  }
  if (header.link_count > mesh_capacity) {
    return Status::image_too_large;
  }
  const Status opened = open_meshes(bytes, meshes, robot.cell_bits);
  return opened != Status::done || check_spheres(robot) ? opened : Status::image_invalid;
}

}  // namespace detail

uint32_t robot_hash(const Robot& robot) {
  uint32_t hash = hash_of(robot.joints, robot.joint_count, kNoHash);
  hash = hash_of(robot.links, robot.link_count, hash);
  hash = hash_of(robot.pairs, robot.pair_count, hash);
  hash = hash_of(robot.reaches, robot.reach_count, hash);
  hash = hash_of(robot.distance_tables, robot.distance_table_bytes, hash);
  hash = hash_of(&robot.slack, 1, hash);
  hash = hash_of(&robot.cell_bits, 1, hash);
  for (uint32_t i = 0; i < robot.link_count; ++i) {
    const Mesh& mesh = robot.meshes[i];
    hash = hash_of(mesh.nodes, mesh.node_count, hash);
    hash = hash_of(mesh.triangles, mesh.triangle_count, hash);
    hash = hash_of(mesh.vertices, mesh.vertex_count, hash);
    hash = hash_of(mesh.origin, 3, hash);
  }
  return hash;
}

Status read_robot_image_header(const void* bytes, size_t size, RobotImageHeader& header) {
  uint32_t magic = 0;
  if (size < sizeof magic) {
    return Status::image_truncated;
  }
  memcpy(&magic, bytes, sizeof magic);
  if (magic != kRobotImageMagic) {
    return Status::image_not_flashbvh;
  }
  if (size < sizeof header) {
    return Status::image_truncated;
  }
  memcpy(&header, bytes, sizeof header);
  if (header.version != kRobotImageVersion) {
    return Status::image_version;
  }
  return header.byte_count > size ? Status::image_truncated : Status::done;
}

Status open_robot(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                  Robot& robot) {
  Status status = open_robot_unhashed(bytes, size, meshes, mesh_capacity, robot);
  if (status == Status::done && robot_hash(robot) != robot.hash) {
    status = Status::image_corrupt;
  }
  if (status != Status::done) {
    robot = {};
    for (uint32_t i = 0; i < mesh_capacity; ++i) {
      meshes[i] = {};
    }
  }
  return status;
}

Robot view_robot_unchecked(const void* image, Mesh* meshes) {
  const RobotImageHeader& header = header_of(image);
  uint32_t offset = robot_meshes_offset(header);
  for (uint32_t i = 0; i < header.link_count; ++i) {
    const ImageHeader* const mesh = image_part<ImageHeader>(image, offset);
    meshes[i] = view_unchecked<Mesh>(mesh);
    offset += mesh->byte_count;
  }
  Robot robot;
  view(image, meshes, robot);
  return robot;
}

const char* robot_name(const void* image) {
  return name_of(image, 0);
}

const char* joint_name(const void* image, uint32_t joint) {
  return name_of(image, 1 + joint);
}

const char* link_name(const void* image, uint32_t link) {
  return name_of(image, 1u + header_of(image).joint_count + link);
}

uint32_t mount_count(const void* image) {
  return header_of(image).mount_count;
}

const Mount* mounts(const void* image) {
  return image_part<Mount>(image, mounts_offset(header_of(image)));
}

const char* mount_name(const void* image, uint32_t mount) {
  return link_name(image, header_of(image).link_count + mount);
}

uint32_t unguarded_count(const void* image) {
  return header_of(image).unguarded_count;
}

const RobotUnguarded* unguarded_pairs(const void* image) {
  return image_part<RobotUnguarded>(image, unguarded_offset(header_of(image)));
}

}  // namespace flashbvh
