// A robot's binary image: joints, links, the pairs that can collide and the links' meshes in one
// block of bytes, opened in place, in flash.
//
// A header of 52 bytes, then, each at a multiple of 4 bytes:
//
//     joints   joint_count  x 72 bytes, RobotJoint
//     links    link_count   x 24 bytes, RobotLink
//     pairs    pair_count   x 16 bytes, RobotPair
//     reaches  reach_count  x  4 bytes
//     mounts   mount_count  x 52 bytes, Mount
//     unguarded  unguarded_count x 8 bytes, RobotUnguarded
//     distance tables   distance_table_bytes  bytes
//     names    names_size   bytes: the robot's, the joints', the links', the mounts', each
//                           ended by a zero
//     meshes   link_count   images (image.hpp), post-indexed, with 16-bit indices
//
// Little-endian. lib/docs/format.md has every bit.
#ifndef FLASHBVH_ROBOT_IMAGE_HPP
#define FLASHBVH_ROBOT_IMAGE_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

constexpr uint32_t kRobotImageMagic = 0x52564246u;  // "FBVR"
constexpr uint16_t kRobotImageVersion = 4;

/// Most bytes of a name in it, without the zero at its end.
constexpr uint32_t kMaxRobotNameSize = 255;

/// The first 52 bytes of a robot's image.
struct RobotImageHeader {
  uint32_t magic;
  uint16_t version;
  uint8_t joint_count;
  uint8_t link_count;
  uint32_t byte_count;            ///< of the whole image
  uint32_t crc;                   ///< CRC-32 of all bytes before the meshes but these four
  uint32_t hash;                  ///< Robot::hash
  uint32_t slack;                 ///< Robot::slack
  uint32_t cell[2];               ///< in metres: IEEE binary64, low word first
  uint32_t pair_joint_count;      ///< between the links of all pairs: what a GuardState holds
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

/// Checks magic, version and size, and copies the header, which says what the robot may be, not
/// whether its contents can be trusted.
Status read_robot_image_header(const void* bytes, size_t size, RobotImageHeader& header);

/// Opens an image in place: `bytes` must start at a multiple of 4 and outlive `robot`, and so must
/// `meshes`, views of its meshes in the caller's memory: link_count of them, 64 bytes each on a
/// 32-bit core. They may be written whatever the status; `robot` is on `done` alone. Then no guard
/// and no motion query of it reads outside the image, overflows or runs on without end.
///
/// Proven are the joints' tree, types, limits, mimics and frames; where each link's reaches stand,
/// that its sphere holds its mesh, that the slack covers its deviation, and that nothing gets
/// farther from the base than frames can say; of each pair the joints between, the sum of their
/// reaches and its distances, and how many bytes its distance table has; each mount's joint; that
/// the pairs that are not guarded are none of the guarded ones, and that the joint of a zone is the
/// one between them; each mesh, by open_image(); that all have one cell; the hash.
///
/// Trusted is what can't be worked out from the rest, and bounds what a guard's word is worth: how
/// far turning joints move links (the reaches), what the distance tables say, that the other pairs
/// never collide, and of the slack all but the links' deviations and what rounding vertices takes.
/// `flashbvh robot` works them out.
///
/// Statuses: those of open_image(); image_corrupt as well if the hash is another one;
/// image_too_large if the robot has more than `mesh_capacity` links; cell_mismatch if a mesh has
/// another cell than the robot.
///
/// Instructions on a Cortex-M4, at most: 1,000 a joint, 500 a link and 12 a joint on its branch, 30
/// a joint between the links of a pair, 110 a vertex, 6 a byte of the meshes' trees and triangles,
/// and of each mesh what open_image() takes. Stack: 600 bytes on Cortex-M3 to M55 at -O2.
Status open_robot(const void* bytes, size_t size, Mesh* meshes, uint32_t mesh_capacity,
                  Robot& robot);

/// The robot in an image that the firmware's own build has baked, as `flashbvh robot` writes it
/// into C: a view without any check, in time linear in its links. What comes from elsewhere is for
/// open_robot(). Precondition: as there, and `meshes` has a place for each link.
Robot view_robot_unchecked(const void* image, Mesh* meshes);

/// Its name, for people, of an image that was opened or baked; ends with a zero.
const char* robot_name(const void* image);
/// Of a joint, numbered below Robot::joint_count. Takes time linear in all names.
const char* joint_name(const void* image, uint32_t joint);
/// Of a link, numbered below Robot::link_count. What of a link lies outside a joint zone is a body
/// of its own, behind the links, with the link's name.
const char* link_name(const void* image, uint32_t link);

/// Where tools are fastened, of an image that was opened: the frames of all links of the URDF.
uint32_t mount_count(const void* image);
/// So many of them, in the image.
const Mount* mounts(const void* image);
/// Of a mount, numbered below mount_count(): its link's.
const char* mount_name(const void* image, uint32_t mount);

/// Pairs of links that a joint moves and that no guard looks at, or only outside a joint zone, of
/// an image that was opened.
uint32_t unguarded_count(const void* image);
/// So many of them, in the image; ascending by a, then b.
const RobotUnguarded* unguarded_pairs(const void* image);

/// FNV-1a of the joints, links, pairs, reaches, distance tables, slack and cell, and of each mesh's
/// nodes, triangles, vertices and origin: what Robot::hash must be. For programs that write robots.
uint32_t robot_hash(const Robot& robot);

}  // namespace flashbvh

#endif
