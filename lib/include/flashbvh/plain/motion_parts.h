/* Motions of a body with a free pose, and what is found of them. Of C++ and C alike: `Move` is
 * `flashbvh_move`. */
#ifndef FLASHBVH_PLAIN_MOTION_PARTS_H
#define FLASHBVH_PLAIN_MOTION_PARTS_H

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/results.h"

/** A part of a motion: a turn about an axis, at constant speed, while the axis travels straight.
 * A screw travels along its axis, a translation does not turn, a joint that turns does not travel.
 * Numbers are those of A's frame where the motion begins. 40 bytes. */
typedef struct flashbvh_move {
  int32_t point[3];  /**< of the axis, in 1/2,048 cell; not read where `turn` is 0 */
  int32_t axis[3];   /**< its direction, FLASHBVH_ROTATION_ONE is 1; not read where `turn` is 0 */
  int32_t turn;      /**< FLASHBVH_FULL_TURN is a full one; counter-clockwise seen from its tip */
  int32_t travel[3]; /**< in 1/2,048 cell */
} flashbvh_move;

/** What is found of a motion of two bodies. */
typedef enum flashbvh_contact_outcome {
  FLASHBVH_OUTCOME_FREE = 0,    /**< at no moment they touch */
  FLASHBVH_OUTCOME_CONTACT = 1, /**< they touch at `to`, and at no moment before `from` */
  FLASHBVH_OUTCOME_CLOSE = 2 /**< they come within a cell between `from` and `to`, may touch there,
                                and at no moment before */
} flashbvh_contact_outcome;

#ifdef __cplusplus
namespace flashbvh {
enum class [[nodiscard]] ContactOutcome : uint8_t;
}  // namespace flashbvh
#endif

/** What a run of a first contact gave. Times are binary fractions of the motion,
 * FLASHBVH_MOTION_END is its end; the two are at most one cell of motion apart. */
typedef struct FLASHBVH_KEEP flashbvh_first_contact_answer {
  FLASHBVH_BYTE(Status) status;          /**< a flashbvh_status */
  FLASHBVH_BYTE(ContactOutcome) outcome; /**< a flashbvh_contact_outcome; of DONE */
  flashbvh_pair triangles;               /**< by their ids; not of a motion that is free */
  uint32_t from; /**< of SUSPENDED: up to there it is certified, or was passed over */
  uint32_t to;
} flashbvh_first_contact_answer;

#endif
