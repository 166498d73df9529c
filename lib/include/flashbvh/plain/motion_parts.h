/* Motions of a body with a free pose. For C and C++: `Move` is `flashbvh_move`. */
#pragma once

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/results.h"

/** A part of a motion: a turn about an axis at constant speed, while the axis moves straight. A
 * screw moves along its axis, a translation does not turn, a revolute joint's axis does not move.
 * Numbers are in A's frame, as at the start of the motion. 40 bytes. */
typedef struct flashbvh_move {
  int32_t point[3];  /**< a point on the axis, in 1/2,048 cell; ignored if `turn` is 0 */
  int32_t axis[3];   /**< its direction, FLASHBVH_ROTATION_ONE is 1; ignored if `turn` is 0 */
  int32_t turn;      /**< FLASHBVH_FULL_TURN is a full one; counter-clockwise seen from its tip */
  int32_t travel[3]; /**< translation of the axis, in 1/2,048 cell */
} flashbvh_move;

/** Outcomes of a motion of two bodies. */
typedef enum flashbvh_contact_outcome {
  FLASHBVH_OUTCOME_FREE = 0,    /**< they touch at no moment */
  FLASHBVH_OUTCOME_CONTACT = 1, /**< they touch at `to`, and at no moment before `from` */
  FLASHBVH_OUTCOME_CLOSE = 2    /**< they come near between `from` and `to`, may touch there, and
                                   touch at no moment before. They come nearer than `within`, two
                                   cells, and twice the path's error: 1/128 to 1/14 cell for each
                                   move, and how far inexact matrices miss the motion's end */
} flashbvh_contact_outcome;

#ifdef __cplusplus
namespace flashbvh {
enum class [[nodiscard]] ContactOutcome : uint8_t;
}  // namespace flashbvh
#endif

/** The result of a first contact's run. Times are binary fractions of the motion, which ends at
 * FLASHBVH_MOTION_END; `from` and `to` are at most one cell of motion apart. */
typedef struct FLASHBVH_KEEP flashbvh_first_contact_answer {
  FLASHBVH_BYTE(Status) status;          /**< a flashbvh_status */
  FLASHBVH_BYTE(ContactOutcome) outcome; /**< a flashbvh_contact_outcome; valid if DONE */
  flashbvh_pair triangles;               /**< by their ids; not valid for FREE */
  uint32_t from;                         /**< if SUSPENDED: certified or passed over up to here */
  uint32_t to;
} flashbvh_first_contact_answer;
