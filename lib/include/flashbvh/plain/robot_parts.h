/* A baked robot, and the results of guards and motions. For C and C++: `RobotJoint` is
 * `flashbvh_robot_joint`. */
#pragma once

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/points.h"
#include "flashbvh/plain/results.h"

/** A joint's coordinate: 2^-28 of a turn for a revolute joint, 1/2,048 cell for a prismatic one. */
typedef int32_t flashbvh_joint_coordinate;

/** A mounting frame on a robot, in a joint's frame or in the base's. A robot's header has the
 * mounts of all links of its URDF, with geometry or without. */
typedef struct flashbvh_mount {
  uint8_t joint; /**< a joint's number, or FLASHBVH_BASE */
  flashbvh_frame frame;
} flashbvh_mount;

/** How a joint moves. */
typedef enum flashbvh_joint_type {
  FLASHBVH_JOINT_REVOLUTE = 0,
  FLASHBVH_JOINT_CONTINUOUS = 1, /**< revolute, without limits: coordinates a full turn apart are
                                    equal */
  FLASHBVH_JOINT_PRISMATIC = 2,
  FLASHBVH_JOINT_FIXED = 3 /**< carries a body that was added to a robot; no value moves it */
} flashbvh_joint_type;

/** Reasons why no guard checks two links that a joint moves. */
typedef enum flashbvh_why_unguarded {
  FLASHBVH_UNGUARDED_ZONE = 0,    /**< neighbours, in a zone about the joint between them */
  FLASHBVH_UNGUARDED_BELIEVED = 1 /**< they may collide, but an SRDF disables the pair and --believe
                                     names it */
} flashbvh_why_unguarded;

/** A guard's verdicts on a period, from the best to the worst. */
typedef enum flashbvh_verdict {
  FLASHBVH_VERDICT_FREE = 0,    /**< all pairs are farther apart than their warn distance */
  FLASHBVH_VERDICT_WARN = 1,    /**< all are farther apart than their stop distance; some maybe not
                                   than the warn distance */
  FLASHBVH_VERDICT_LEAVING = 2, /**< a pair has been inside its stop distance since the start, and
                                   got no nearer than a tenth of it: only what limit grants */
  FLASHBVH_VERDICT_NOT_YET_KNOWN = 3, /**< the work budget was too small */
  FLASHBVH_VERDICT_STOP = 4, /**< a pair is not farther apart than its stop distance, or this is not
                                decidable */
  FLASHBVH_VERDICT_REFUSED = 5 /**< the values were rejected and nothing changed: the status says
                                  why */
} flashbvh_verdict;

/** Outcomes of a robot's motion. */
typedef enum flashbvh_motion_outcome {
  FLASHBVH_MOTION_FREE = 0, /**< no pair that can collide intersects at any moment */
  FLASHBVH_MOTION_HIT = 1,  /**< a pair intersects at the moment reported */
  FLASHBVH_MOTION_CLOSE = 2 /**< a pair is nearer than three times the robot's slack at about the
                               moment reported; it may intersect */
} flashbvh_motion_outcome;

#ifdef __cplusplus
namespace flashbvh {
enum class JointType : uint8_t;
enum class WhyUnguarded : uint8_t;
enum class [[nodiscard]] Verdict : uint8_t;
enum class [[nodiscard]] LimitVerdict : uint8_t;
enum class [[nodiscard]] MotionOutcome : uint8_t;
enum class Layout : uint8_t;
template <class Index, Layout layout>
struct BasicMesh;
}  // namespace flashbvh
/** A Mesh; C has it as a flashbvh_mesh. */
typedef flashbvh::BasicMesh<uint16_t, flashbvh::Layout{1}> flashbvh_link_mesh;
#else
typedef struct flashbvh_mesh flashbvh_link_mesh;
#endif

/** A joint. 72 bytes. */
typedef struct flashbvh_robot_joint {
  flashbvh_frame fixed; /**< the joint's frame in its parent's, at coordinate 0 */
  flashbvh_joint_coordinate
      lower; /**< limits, both included; 0 and ignored for a continuous joint */
  flashbvh_joint_coordinate upper;
  /** If the joint mimics another one, its coordinate is (value * multiplier >> shift) + offset,
   * rounded to the nearest; `value` is that joint's. Else `shift` is 0. */
  int32_t multiplier;
  flashbvh_joint_coordinate offset;
  uint8_t shift;                 /**< 0, or 1 to 40 */
  uint8_t parent;                /**< a joint with a lower number, or FLASHBVH_BASE */
  uint8_t variable;              /**< the number of the caller's value that moves it */
  FLASHBVH_BYTE(JointType) type; /**< a flashbvh_joint_type */
  /** 0 in an image. Of an obstacle: how often it has moved by 2^24, in 1/256 cell; `offset` counts
   * its path modulo 2^32. */
  uint32_t laps;
} flashbvh_robot_joint;

/** A body: a part of the robot with a mesh, which has an equal number. 24 bytes. */
typedef struct flashbvh_robot_link {
  /** A sphere around the mesh: centre in the joint's frame and radius, in 1/2,048 cell. */
  int32_t centre[3];
  uint32_t radius;
  /** Index of the first reach of the link's branch, from its own joint to the base. */
  uint16_t first_reach;
  uint8_t joint; /**< a joint's number, or FLASHBVH_BASE */
  uint8_t padding;
  /** Largest distance of a point of the URDF's link from the mesh, in 1/256 cell: the error of
   * rounding to the lattice and of simplifying. Robot::slack includes it. */
  uint32_t deviation;
} flashbvh_robot_link;

/** Two links that can collide. 16 bytes. */
typedef struct flashbvh_robot_pair {
  uint32_t stop; /**< in 1/256 cell */
  uint32_t warn; /**< at least `stop` */
  /** Sum of the reaches of all joints between the two links; fits 32 bits. */
  uint32_t reach;
  uint8_t a; /**< links */
  uint8_t b;
  /** Number of joints on a's branch, from its own inwards, that are not on b's; and the reverse. */
  uint8_t joints_a;
  uint8_t joints_b;
} flashbvh_robot_pair;

/** Two links that a joint moves and that no guard checks, everywhere or in a zone: collisions there
 * are never detected. 8 bytes. */
typedef struct flashbvh_robot_unguarded {
  uint8_t a; /**< links */
  uint8_t b;
  FLASHBVH_BYTE(WhyUnguarded) why; /**< a flashbvh_why_unguarded */
  /** For a joint zone: the joint between them, about which they may touch. Else FLASHBVH_BASE. */
  uint8_t joint;
  /** For a joint zone, in 1/256 cell: the radius of a ball, or of the cylinder along a prismatic
   * joint. Else 0: the links are not checked anywhere. */
  uint32_t radius;
} flashbvh_robot_unguarded;

/** A robot: a view of arrays, which must outlive it. */
typedef struct flashbvh_robot {
  const flashbvh_robot_joint* joints; /**< joint_count, parents before children */
  const flashbvh_robot_link* links;   /**< link_count */
  const flashbvh_link_mesh* meshes;   /**< link_count */
  const flashbvh_robot_pair* pairs;   /**< pair_count */
  /** Upper bounds of the motion of any point of a link by a joint, at any values of the joints
   * between: in 2^-FLASHBVH_REACH_BITS of 1/256 cell for a unit of its coordinate, rounded up. */
  const uint32_t* reaches;
  /** Bytes. For pairs with one or two joints between: lower bounds of the distance by these joints'
   * values. */
  const uint8_t* distance_tables;
  uint8_t joint_count;
  uint8_t link_count;
  uint8_t variable_count; /**< number of values that the caller gives */
  uint8_t padding;
  uint16_t pair_count;
  uint16_t reach_count;
  /** How much nearer two of the URDF's links may be than their placed meshes, in 1/256 cell. It
   * covers both links' deviations, the rounding of placed vertices and fixed-point kinematics. */
  uint32_t slack;
  uint32_t distance_table_bytes; /**< bytes; 0: guards work without tables */
  uint32_t hash;                 /**< of all data, never 0: distinguishes robots */
  uint64_t cell_bits;            /**< the cell in metres, as the bits of an IEEE binary64 */
} flashbvh_robot;

/** The result of a guard's period. */
typedef struct FLASHBVH_KEEP flashbvh_guard_answer {
  /** A flashbvh_status: DONE; with the verdict REFUSED the reason: NOT_A_COORDINATE,
   * JOINT_OUT_OF_LIMITS, JOINT_JUMPED, GUARD_STATE_INVALID; with NOT_YET_KNOWN a query's error. */
  FLASHBVH_BYTE(Status) status;
  FLASHBVH_BYTE(Verdict) verdict; /**< a flashbvh_verdict: the worst of all pairs */
  uint16_t pair; /**< number of the pair with the least clearance among those with this verdict */
  /** Lower bound of the distance of its links in the period, in 1/256 cell, for every verdict. */
  uint32_t distance;
  uint32_t work; /**< work spent */
} flashbvh_guard_answer;

/** What flashbvh_guard_limit() made of the wanted values. */
typedef enum flashbvh_limit_verdict {
  FLASHBVH_LIMIT_GRANTED = 0,       /**< all of the motion */
  FLASHBVH_LIMIT_SHORTENED = 1,     /**< a part: farther, `pair` would come too near */
  FLASHBVH_LIMIT_HELD = 2,          /**< nothing, for `pair` */
  FLASHBVH_LIMIT_NOT_YET_KNOWN = 3, /**< a part or nothing, since the work budget was too small */
  FLASHBVH_LIMIT_REFUSED = 4        /**< the values were rejected: the status says why */
} flashbvh_limit_verdict;

/** The result of flashbvh_guard_limit(). */
typedef struct FLASHBVH_KEEP flashbvh_limit_answer {
  FLASHBVH_BYTE(Status) status;        /**< as of a flashbvh_guard_answer */
  FLASHBVH_BYTE(LimitVerdict) verdict; /**< a flashbvh_limit_verdict */
  uint16_t share;                      /**< of the motion, in 1/4,096 */
  uint16_t pair;                       /**< the pair that allows no more, or FLASHBVH_NO_PAIR */
  uint16_t opposed;  /**< another pair that allowed less than all, or FLASHBVH_NO_PAIR */
  uint32_t floor;    /**< of `pair`, in 1/256 cell; 0 also while it touches, or is released */
  uint32_t distance; /**< of `pair` at the granted values, at least */
  uint32_t work;     /**< work spent */
} flashbvh_limit_answer;

/** The result of a motion query's run. */
typedef struct FLASHBVH_KEEP flashbvh_motion_answer {
  /** A flashbvh_status. DONE: all fields are valid; SUSPENDED; or why values were rejected. */
  FLASHBVH_BYTE(Status) status;
  /** A flashbvh_motion_outcome: the first that is found; another pair may hit earlier. */
  FLASHBVH_BYTE(MotionOutcome) outcome;
  uint16_t pair;           /**< number of the robot's pair */
  flashbvh_pair triangles; /**< by their ids; valid for a hit */
  uint32_t numerator;      /**< the moment, numerator / 2^level: flashbvh_motion_set_values() */
  uint8_t level;
} flashbvh_motion_answer;

/** The capacity of a workcell, including the robot's own parts. Each body takes a joint, a link and
 * a reach for each joint between it and the base; each guarded pair takes a pair. */
typedef struct flashbvh_workcell_room {
  uint32_t joints;
  uint32_t links;
  uint32_t pairs;
  uint32_t reaches;
} flashbvh_workcell_room;
