/* Every way a call into flashbvh can end, for C and, by the names of status.hpp, for C++. */
#ifndef FLASHBVH_STATUS_H
#define FLASHBVH_STATUS_H

/** The values are part of the interface: they never change their number. All fit in 8 bits. */
typedef enum flashbvh_status {
  /** The answer is complete. */
  FLASHBVH_STATUS_DONE = 0,
  /** The work granted is done; run again to go on. Nothing is lost. */
  FLASHBVH_STATUS_SUSPENDED = 1,
  /** The caller's array is full; empty it and run again. Nothing is lost. */
  FLASHBVH_STATUS_FULL = 2,

  /** The two meshes were baked with different cells. */
  FLASHBVH_STATUS_CELL_MISMATCH = 16,
  /** A stack traversal's array is shorter than stack_entries(). C++ alone. */
  FLASHBVH_STATUS_STACK_TOO_SMALL = 17,
  /** A translation beyond +-2^29 cells (kMaxTranslation). */
  FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE = 18,
  /** A matrix or quaternion that does more than rotate. */
  FLASHBVH_STATUS_NOT_A_ROTATION = 19,
  /** A stored cursor that is not one of this query's. */
  FLASHBVH_STATUS_CURSOR_INVALID = 20,
  /** A hint that is no pair of the meshes' triangles. */
  FLASHBVH_STATUS_HINT_INVALID = 21,
  /** A distance that is too large, or not decidable for meshes so far apart. */
  FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE = 22,
  /** A mesh that is no closed surface has no inside. */
  FLASHBVH_STATUS_NOT_CLOSED = 23,
  /** A shape that is larger than a mesh can be, or lies further off. */
  FLASHBVH_STATUS_SHAPE_TOO_LARGE = 24,
  /** A ray whose end lies too far from the mesh. */
  FLASHBVH_STATUS_RAY_OUT_OF_RANGE = 25,
  /** A joint's value that is no number, or too large for one. */
  FLASHBVH_STATUS_NOT_A_COORDINATE = 26,
  /** A joint's value outside its limits. */
  FLASHBVH_STATUS_JOINT_OUT_OF_LIMITS = 27,
  /** A joint without limits that moved half a turn or more since the last period: either way. */
  FLASHBVH_STATUS_JOINT_JUMPED = 28,
  /** A guard's memory that is too small, or a state that is not one of this robot's. */
  FLASHBVH_STATUS_GUARD_STATE_INVALID = 29,
  /** A workcell's memory has no room for another body or pair. */
  FLASHBVH_STATUS_WORKCELL_FULL = 30,
  /** The number of a link or a joint that is none, or not one of the kind that the call needs. */
  FLASHBVH_STATUS_LINK_INVALID = 31,

  /** Fewer bytes than the image says it has. */
  FLASHBVH_STATUS_IMAGE_TRUNCATED = 32,
  /** The image does not start at a multiple of 4 bytes. */
  FLASHBVH_STATUS_IMAGE_MISALIGNED = 33,
  /** The first four bytes are not "FBVH". */
  FLASHBVH_STATUS_IMAGE_NOT_FLASHBVH = 34,
  /** Written in another version of the format; bake again. */
  FLASHBVH_STATUS_IMAGE_VERSION = 35,
  /** Another layout or index width than the mesh that the caller wants. */
  FLASHBVH_STATUS_IMAGE_KIND = 36,
  /** The checksum does not match: the bytes were damaged. */
  FLASHBVH_STATUS_IMAGE_CORRUPT = 37,
  /** The checksum matches, but the contents break a rule of the format. */
  FLASHBVH_STATUS_IMAGE_INVALID = 38,
  /** A robot's image with more links than the caller has room for meshes. C++ alone. */
  FLASHBVH_STATUS_IMAGE_TOO_LARGE = 39,

  /** A vertex of a deformable mesh that lies outside the lattice; no query may use the mesh. */
  FLASHBVH_STATUS_VERTEX_OUT_OF_LATTICE = 40,
  /** A mesh that was refit since, or whose refit is not done. */
  FLASHBVH_STATUS_MESH_CHANGED = 41,

  /** A motion of a body that may get farther than 2^19 cells from an origin, by the sum of its
   * lengths. */
  FLASHBVH_STATUS_MOTION_OUT_OF_RANGE = 48,

  /** A known answer came out differently, or memory that does not change has changed. */
  FLASHBVH_STATUS_SELF_TEST_FAILED = 49
} flashbvh_status;

#ifdef __cplusplus
extern "C" {
#endif

/** "cell_mismatch" of FLASHBVH_STATUS_CELL_MISMATCH, for people; "unknown" of other numbers.
 * Firmware that does not call this does not link the names. */
const char* flashbvh_status_name(flashbvh_status status);

#ifdef __cplusplus
}
#endif

#endif
