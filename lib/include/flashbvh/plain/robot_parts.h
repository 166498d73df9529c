/* A baked robot, and what guards and motions answer. Of C++ and C alike: `RobotJoint` is
 * `flashbvh_robot_joint`. */
#ifndef FLASHBVH_PLAIN_ROBOT_PARTS_H
#define FLASHBVH_PLAIN_ROBOT_PARTS_H

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/plain/results.h"

/** Where a joint stands: of one that turns, in 2^-28 of a turn; of one that slides, in 1/2,048
 * cell. */
typedef int32_t flashbvh_joint_coordinate;

/** Where something is fastened to a robot: in the frame that a joint carries, or in the base's. A
 * robot's header has those of all links of its URDF, with geometry or without. */
typedef struct flashbvh_mount {
  uint8_t joint; /**< or FLASHBVH_BASE */
  flashbvh_frame frame;
} flashbvh_mount;

/** How a joint moves. */
typedef enum flashbvh_joint_type {
  FLASHBVH_JOINT_REVOLUTE = 0,
  FLASHBVH_JOINT_CONTINUOUS = 1, /**< revolute, without limits: coordinates a full turn apart are
                                    the same */
  FLASHBVH_JOINT_PRISMATIC = 2,
  FLASHBVH_JOINT_FIXED = 3 /**< carries a body that was added to a robot: no value of the caller's
                              moves it */
} flashbvh_joint_type;

/** Why no guard looks at two links that a joint moves. */
typedef enum flashbvh_why_unguarded {
  FLASHBVH_UNGUARDED_ZONE = 0,    /**< neighbours, in a zone about the joint between them */
  FLASHBVH_UNGUARDED_BELIEVED = 1 /**< they may collide, but an SRDF disables the pair and --believe
                                     names it */
} flashbvh_why_unguarded;

/** What a guard says of a period, from the best to the worst. */
typedef enum flashbvh_verdict {
  FLASHBVH_VERDICT_FREE = 0, /**< farther apart than the warn distance */
  FLASHBVH_VERDICT_WARN = 1, /**< farther apart than the stop distance; maybe not than the warn
                                distance */
  FLASHBVH_VERDICT_NOT_YET_KNOWN = 2, /**< the work budget was too small */
  FLASHBVH_VERDICT_STOP = 3,   /**< not farther apart than the stop distance, or not decidable */
  FLASHBVH_VERDICT_REFUSED = 4 /**< the values were refused and nothing changed: the status says
                                  why */
} flashbvh_verdict;

/** What is found of a motion. */
typedef enum flashbvh_motion_outcome {
  FLASHBVH_MOTION_FREE = 0, /**< no pair that can collide intersects at any moment */
  FLASHBVH_MOTION_HIT = 1,  /**< a pair intersects at the moment reported */
  FLASHBVH_MOTION_CLOSE = 2 /**< a pair is nearer than three times the robot's slack about the
                               moment reported; it may intersect */
} flashbvh_motion_outcome;

#ifdef __cplusplus
namespace flashbvh {
enum class JointType : uint8_t;
enum class WhyUnguarded : uint8_t;
enum class [[nodiscard]] Verdict : uint8_t;
enum class [[nodiscard]] MotionOutcome : uint8_t;
enum class Layout : uint8_t;
template <class Index, Layout layout>
struct BasicMesh;
}  // namespace flashbvh
/** A Mesh, which C has as a flashbvh_mesh. */
typedef flashbvh::BasicMesh<uint16_t, flashbvh::Layout{1}> flashbvh_link_mesh;
#else
typedef struct flashbvh_mesh flashbvh_link_mesh;
#endif

/** A joint. 72 bytes. */
typedef struct flashbvh_robot_joint {
  flashbvh_frame fixed; /**< its frame in its parent's, at coordinate 0 */
  flashbvh_joint_coordinate
      lower; /**< limits, both allowed; of a continuous joint 0 and not read */
  flashbvh_joint_coordinate upper;
  /** Of a joint that mimics another one, whose value is the caller's: its coordinate is
   * (value * multiplier >> shift) + offset, rounded to the nearest. Else `shift` is 0. */
  int32_t multiplier;
  flashbvh_joint_coordinate offset;
  uint8_t shift;                 /**< 0, or 1 to 40 */
  uint8_t parent;                /**< a joint before it, or FLASHBVH_BASE */
  uint8_t variable;              /**< which of the caller's values moves it */
  FLASHBVH_BYTE(JointType) type; /**< a flashbvh_joint_type */
  uint32_t padding;
} flashbvh_robot_joint;

/** A body: what of the robot has a mesh, that of the same number. 24 bytes. */
typedef struct flashbvh_robot_link {
  /** A sphere that holds the mesh: centre in the joint's frame and radius, in 1/2,048 cell. */
  int32_t centre[3];
  uint32_t radius;
  /** Of the robot's reaches: the first of those of its branch, from its own joint to the base. */
  uint16_t first_reach;
  uint8_t joint; /**< or FLASHBVH_BASE */
  uint8_t padding;
  /** How far a point of the link, as the URDF has it, may lie from the mesh, in 1/256 cell: what
   * rounding to the lattice and simplifying moved it. Robot::slack has it. */
  uint32_t deviation;
} flashbvh_robot_link;

/** Two links that can collide. 16 bytes. */
typedef struct flashbvh_robot_pair {
  uint32_t stop; /**< distances, in 1/256 cell */
  uint32_t warn; /**< at least `stop` */
  /** The sum of the reaches of all joints between the two; fits 32 bits. */
  uint32_t reach;
  uint8_t a; /**< links */
  uint8_t b;
  /** How many joints of a's branch, from its own inwards, are not of b's; and the other way round.
   */
  uint8_t joints_a;
  uint8_t joints_b;
} flashbvh_robot_pair;

/** Of two links that a joint moves, what no guard looks at: a collision there is never detected.
 * 8 bytes. */
typedef struct flashbvh_robot_unguarded {
  uint8_t a; /**< links */
  uint8_t b;
  FLASHBVH_BYTE(WhyUnguarded) why; /**< a flashbvh_why_unguarded */
  /** Of a joint zone: the joint between the two, about which they may touch. Else FLASHBVH_BASE. */
  uint8_t joint;
  /** Of a joint zone, in 1/256 cell: of a ball, or of the cylinder along a joint that slides. Else
   * 0: they are not looked at anywhere. */
  uint32_t radius;
} flashbvh_robot_unguarded;

/** A robot: a view of arrays that outlive it. */
typedef struct flashbvh_robot {
  const flashbvh_robot_joint* joints; /**< joint_count, parents before children */
  const flashbvh_robot_link* links;   /**< link_count */
  const flashbvh_link_mesh* meshes;   /**< link_count */
  const flashbvh_robot_pair* pairs;   /**< pair_count */
  /** How far a joint moves any point of a link, whatever the joints between the two: in
   * 2^-FLASHBVH_REACH_BITS of 1/256 cell a unit of the joint's coordinate, rounded up. */
  const uint32_t* reaches;
  /** Of pairs with one or two joints between: how far apart at least, by where these stand; bytes.
   */
  const uint8_t* distance_tables;
  uint8_t joint_count;
  uint8_t link_count;
  uint8_t variable_count; /**< how many values the caller gives */
  uint8_t padding;
  uint16_t pair_count;
  uint16_t reach_count;
  /** How far two of its links, as the URDF has them, may be nearer to each other than their placed
   * meshes, in 1/256 cell: both links' deviations, what rounding vertices when they are placed
   * moves, and kinematics in fixed point. */
  uint32_t slack;
  uint32_t distance_table_bytes; /**< 0: a guard does without */
  uint32_t hash;                 /**< of all of it: distinguishes robots */
  uint64_t cell_bits;            /**< the cell in metres, as the bits of an IEEE binary64 */
} flashbvh_robot;

/** What is known of a period. */
typedef struct FLASHBVH_KEEP flashbvh_guard_answer {
  /** A flashbvh_status: DONE; or, with the verdict REFUSED, why nothing changed: NOT_A_COORDINATE,
   * JOINT_OUT_OF_LIMITS, JOINT_JUMPED, GUARD_STATE_INVALID; or a query's error, with
   * NOT_YET_KNOWN. */
  FLASHBVH_BYTE(Status) status;
  FLASHBVH_BYTE(Verdict) verdict; /**< a flashbvh_verdict: the worst of all pairs */
  uint16_t pair; /**< of the robot's pairs: that of the least clearance with this verdict */
  /** Its links stayed at least so far apart, in 1/256 cell, whatever the verdict: what is known. */
  uint32_t distance;
  uint32_t work; /**< that was spent */
} flashbvh_guard_answer;

/** How far a query of a motion came. */
typedef struct FLASHBVH_KEEP flashbvh_motion_answer {
  /** A flashbvh_status. DONE: the rest holds; SUSPENDED; or why values were refused. */
  FLASHBVH_BYTE(Status) status;
  /** A flashbvh_motion_outcome: the first that is found; another pair may hit earlier. */
  FLASHBVH_BYTE(MotionOutcome) outcome;
  uint16_t pair;           /**< of the robot's pairs */
  flashbvh_pair triangles; /**< by their ids; of a hit */
  uint32_t numerator;      /**< numerator / 2^level of the way: flashbvh_motion_set_values() */
  uint8_t level;
} flashbvh_motion_answer;

/** The most that a workcell holds, with what the robot has: each body takes a joint, a link and, on
 * its way to the base, a reach for each joint; each pair a pair. */
typedef struct flashbvh_workcell_room {
  uint32_t joints;
  uint32_t links;
  uint32_t pairs;
  uint32_t reaches;
} flashbvh_workcell_room;

#endif
