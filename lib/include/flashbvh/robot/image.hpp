// A robot's binary image: joints, links, the pairs that can collide and the links' meshes in one
// block of bytes, used in place in flash. lib/docs/format.md has every bit.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

constexpr uint32_t kRobotImageMagic = 0x52564246u;  // "FBVR"
constexpr uint16_t kRobotImageVersion = 5;

/// Most bytes of a name, without the zero at its end.
constexpr uint32_t kMaxRobotNameSize = 255;

/// The first 52 bytes of a robot's image.
struct RobotImageHeader {
  uint32_t magic;
  uint16_t version;
  uint8_t joint_count;
  uint8_t link_count;
  uint32_t byte_count;            ///< of the whole image
  uint32_t crc;                   ///< CRC-32 of all bytes before the meshes except these four
  uint32_t hash;                  ///< Robot::hash
  uint32_t slack;                 ///< Robot::slack
  uint32_t cell[2];               ///< the cell in metres: IEEE binary64, low word first
  uint32_t pair_joint_count;      ///< sum over all pairs, for GuardStateOf
  uint32_t distance_table_bytes;  ///< Robot::distance_table_bytes
  uint16_t pair_count;
  uint16_t reach_count;
  uint16_t names_size;
  uint8_t variable_count;
  uint8_t mount_count;
  uint16_t unguarded_count;
  uint16_t padding;
};

static_assert(sizeof(RobotImageHeader) == 52, "the figure in the format's description");

/// Checks magic, version and size, and copies the header. The header says what the robot may be;
/// its contents may still be invalid.
Status read_robot_image_header(const void* bytes, size_t size, RobotImageHeader& header);

/// Opens an image in place. `bytes` must start at a multiple of 4. `bytes` and `meshes` must
/// outlive `robot`. `meshes` takes views of the image's meshes: link_count views, 72 bytes each on
/// a 32-bit core. On `done` no guard or motion query of the robot reads outside the image,
/// overflows or fails to end. After an error neither the robot nor any of the `mesh_capacity`
/// meshes is open: guards, motions and queries on them return `not_open`.
///
/// Checks each rule of lib/docs/format.md, of meshes as open_image() does, but four facts that
/// other data do not determine: the reaches of revolute joints, the contents of the distance
/// tables, that the other pairs never collide, and the links' deviations with the share of
/// kinematics in the slack. A guard's guarantee depends on these, which `flashbvh robot` computes.
///
/// Statuses: those of open_image(). `image_corrupt` also if the hash differs. `image_too_large`:
/// the robot has more than `mesh_capacity` links. `cell_mismatch`: a mesh and the robot have
/// different cells.
///
/// Instructions on a Cortex-M4, at most: 1,000 a joint, 500 a link and 12 a joint on its branch, 30
/// a joint between the links of a pair, 110 a vertex, 6 a byte of the meshes' trees and triangles,
/// and open_image() for each mesh. Stack: 600 bytes on Cortex-M3 to M55 at -O2.
Status open_robot(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                  Robot& robot);

/// Returns the robot of an image that the firmware's own build has baked (`flashbvh robot` writes
/// C). A view without any check, in time linear in its links. open_robot() is for other images and
/// has the preconditions; a null pointer is not detected. `meshes` has link_count entries. At
/// namespace scope such a line needs a start-up file that runs constructors; without, guards refuse
/// (lib/docs/guide.md, "Start-up").
Robot view_robot_unchecked(const void* image, Mesh* meshes);

/// Returns the robot's name, for people, from an image that was opened or baked; ends with a zero.
const char* robot_name(const void* image);
/// Returns a joint's name. `joint`: below Robot::joint_count. Time is linear in all names.
const char* joint_name(const void* image, uint32_t joint);
/// Returns a link's name. `link`: below Robot::link_count. The part of a link outside a joint zone
/// is a body of its own, after the links, with the link's name.
const char* link_name(const void* image, uint32_t link);

/// Returns the number of mounts in an image that was opened: frames of all links of the URDF.
uint32_t mount_count(const void* image);
/// Returns these mounts, in the image.
const Mount* mounts(const void* image);
/// Returns the name of a mount's link. `mount`: below mount_count().
const char* mount_name(const void* image, uint32_t mount);

/// Returns the number of pairs of links that a joint moves and that no guard checks, or checks only
/// outside a joint zone. For an image that was opened.
uint32_t unguarded_count(const void* image);
/// Returns these pairs, in the image; ascending by a, then b.
const RobotUnguarded* unguarded_pairs(const void* image);

/// Returns Robot::hash: FNV-1a of the joints, links, pairs, reaches, distance tables, slack and
/// cell, and of each mesh's nodes, triangles, vertices and origin; never 0. For programs that write
/// robots.
uint32_t robot_hash(const Robot& robot);

}  // namespace flashbvh
