/* Every way in which a flashbvh call can end, for C and, by the names of status.hpp, for C++. */
#pragma once

/** The values are part of the interface and never change. All fit 8 bits. */
typedef enum flashbvh_status {
  /** The answer is complete. */
  FLASHBVH_STATUS_DONE = 0,
  /** The granted work is spent; run again to continue. Nothing is lost. */
  FLASHBVH_STATUS_SUSPENDED = 1,
  /** The caller's array is full; empty it and run again to continue. Nothing is lost. */
  FLASHBVH_STATUS_FULL = 2,

  /** The two meshes have different cells, or a refit is not done, or a shape does not fit. */
  FLASHBVH_STATUS_CELL_MISMATCH = 16,
  /** The array for a query's stack is too short (traversal/pair_stack.hpp); C has no such query. */
  FLASHBVH_STATUS_STACK_TOO_SMALL = 17,
  /** A translation is beyond +-2^29 cells (kMaxTranslation). */
  FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE = 18,
  /** A matrix or quaternion is not a pure rotation. */
  FLASHBVH_STATUS_NOT_A_ROTATION = 19,
  /** A stored cursor is not possible in this query. */
  FLASHBVH_STATUS_CURSOR_INVALID = 20,
  /** A hint is no pair of the meshes' triangles. */
  FLASHBVH_STATUS_HINT_INVALID = 21,
  /** A distance is too large, or not decidable for meshes so far apart. */
  FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE = 22,
  /** A mesh is not a closed surface, so it has no inside. */
  FLASHBVH_STATUS_NOT_CLOSED = 23,
  /** A shape is larger than a mesh can be, or farther away. */
  FLASHBVH_STATUS_SHAPE_TOO_LARGE = 24,
  /** A ray's end is too far from the mesh. */
  FLASHBVH_STATUS_RAY_OUT_OF_RANGE = 25,
  /** A joint's value is not a number, or too large for one. */
  FLASHBVH_STATUS_NOT_A_COORDINATE = 26,
  /** A joint's value is outside its limits. */
  FLASHBVH_STATUS_JOINT_OUT_OF_LIMITS = 27,
  /** A joint without limits moved by exactly half a turn in one period, or its geared mimic by half
   * a turn or more: its direction is ambiguous. Or an obstacle moved too far (Workcell::move()). */
  FLASHBVH_STATUS_JOINT_JUMPED = 28,
  /** A guard's memory is too small, or its state is not one of this robot's. */
  FLASHBVH_STATUS_GUARD_STATE_INVALID = 29,
  /** A workcell's memory has no capacity for another body or pair. */
  FLASHBVH_STATUS_WORKCELL_FULL = 30,
  /** A link or joint number does not exist, or has not the kind that the call needs. */
  FLASHBVH_STATUS_LINK_INVALID = 31,

  /** Fewer bytes than the image's header states. */
  FLASHBVH_STATUS_IMAGE_TRUNCATED = 32,
  /** The image does not start at a multiple of 4 bytes. */
  FLASHBVH_STATUS_IMAGE_MISALIGNED = 33,
  /** The first four bytes are not "FBVH", or "FBVR" of a robot. */
  FLASHBVH_STATUS_IMAGE_NOT_FLASHBVH = 34,
  /** The image has another version of the format; bake again. */
  FLASHBVH_STATUS_IMAGE_VERSION = 35,
  /** The image has another layout or index width than the caller's mesh type, or no levels. */
  FLASHBVH_STATUS_IMAGE_KIND = 36,
  /** The checksum does not match: the bytes were damaged. */
  FLASHBVH_STATUS_IMAGE_CORRUPT = 37,
  /** The checksum matches, but the contents break a rule of the format. */
  FLASHBVH_STATUS_IMAGE_INVALID = 38,
  /** A robot's image has more links than the caller has meshes for. */
  FLASHBVH_STATUS_IMAGE_TOO_LARGE = 39,

  /** A vertex of a deformable mesh is outside the lattice; no query may use the mesh. */
  FLASHBVH_STATUS_VERTEX_OUT_OF_LATTICE = 40,
  /** A mesh was refit since, or its refit is not done. */
  FLASHBVH_STATUS_MESH_CHANGED = 41,

  /** A motion may move a body farther than 2^19 cells from an origin, by the sum of its lengths. Or
   * a coordinate of a mesh's origin is 2^18 cells or more. */
  FLASHBVH_STATUS_MOTION_OUT_OF_RANGE = 48,

  /** A known answer differs, or memory that must not change has changed. */
  FLASHBVH_STATUS_SELF_TEST_FAILED = 49,

  /** A mesh or a robot that nobody opened, or whose opening failed: it has no cell, a robot no
   * joints or hash. Or an object that was not made of one. */
  FLASHBVH_STATUS_NOT_OPEN = 50
} flashbvh_status;

#ifdef __cplusplus
extern "C" {
#endif

/** Returns a status's name for people: "cell_mismatch" for FLASHBVH_STATUS_CELL_MISMATCH; "unknown"
 * for other numbers. Firmware that does not call it does not link the names. */
const char* flashbvh_status_name(flashbvh_status status);

#ifdef __cplusplus
}
#endif
