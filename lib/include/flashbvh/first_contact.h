/* flashbvh for C: whether two bodies are apart at every moment of a motion. See
 * first_contact.hpp.
 *
 *     flashbvh_body_motion motion;
 *     flashbvh_first_contact_query query;
 *     flashbvh_body_motion_between(&from, &to, &motion);
 *     flashbvh_first_contact_start(&query, &a, &b, &motion, 256);
 *     answer = flashbvh_first_contact_run(&query, UINT32_MAX);
 *     may_go = answer.status == FLASHBVH_STATUS_DONE && answer.outcome == FLASHBVH_OUTCOME_FREE;
 */
#ifndef FLASHBVH_FIRST_CONTACT_H
#define FLASHBVH_FIRST_CONTACT_H

#include "flashbvh/flashbvh.h"
#include "flashbvh/plain/motion_parts.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The end of a motion. A time is a binary fraction of the motion; 0 is the start. */
#define FLASHBVH_MOTION_END (UINT32_C(1) << 30)

/** BodyMotion: constant once made; any number of queries may share it. It stores an error, which
 * every query on it returns. 188 bytes on a 32-bit core, 192 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_body_motion, 1, 184, uint32_t);

/** The most moves of a motion that a query takes. */
#define FLASHBVH_MOST_MOVES 64
/** The largest `within` of a motion, in 1/256 cell. */
#define FLASHBVH_MAX_MOTION_DISTANCE ((uint32_t)32000 * 256)

/** BodyMotion::between(): straight, with the shorter turn. MOTION_OUT_OF_RANGE; the poses'
 * NOT_A_ROTATION and TRANSLATION_OUT_OF_RANGE. */
flashbvh_status flashbvh_body_motion_between(const flashbvh_pose* from, const flashbvh_pose* to,
                                             flashbvh_body_motion* motion);

/** BodyMotion: `count` moves, which must outlive the motion, from the outermost to the innermost.
 * Statuses as above; NOT_A_ROTATION also if an axis does not have length 1. */
flashbvh_status flashbvh_body_motion_of_moves(const flashbvh_pose* from, const flashbvh_move* moves,
                                              uint32_t count, flashbvh_body_motion* motion);

/** BodyMotion::pose_at(): `time` up to FLASHBVH_MOTION_END. TRANSLATION_OUT_OF_RANGE: the motion
 * has an error. */
flashbvh_status flashbvh_body_motion_pose(const flashbvh_body_motion* motion, uint32_t time,
                                          flashbvh_pose* pose);

/** FirstContact, with all its memory. 80 bytes on a 32-bit core, 96 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_first_contact_query, 3, 68, uint32_t);

/** FirstContactCursor: a query's cursor between runs; internal. May be stored for any time, as
 * bytes too. */
FLASHBVH_OPAQUE(flashbvh_contact_cursor, 0, 36, uint32_t);

/** Starts a query; meshes and motion must outlive it. `within`: bodies this near are in contact; 0:
 * only bodies that intersect. SUSPENDED: there is work to run. The motion's status;
 * MOTION_OUT_OF_RANGE, also for too many moves or far origins; DISTANCE_OUT_OF_RANGE: `within` is
 * beyond FLASHBVH_MAX_MOTION_DISTANCE. Every run returns the status again, or CELL_MISMATCH. */
flashbvh_status flashbvh_first_contact_start(flashbvh_first_contact_query* query,
                                             const flashbvh_mesh* a, const flashbvh_mesh* b,
                                             const flashbvh_body_motion* motion,
                                             flashbvh_fine_length within);

/** FirstContact::run(): does at most `work`, overdrawn by one step; UINT32_MAX: no limit. */
FLASHBVH_NODISCARD flashbvh_first_contact_answer
flashbvh_first_contact_run(flashbvh_first_contact_query* query, uint32_t work);

/** FirstContact::pass(): continues behind the answer CLOSE, as if it were free. */
void flashbvh_first_contact_pass(flashbvh_first_contact_query* query);

/** FirstContact::cursor(). Valid between runs. */
flashbvh_contact_cursor flashbvh_first_contact_cursor(const flashbvh_first_contact_query* query);

/** FirstContact::resume(), for a started query, with the cursor of a suspended one. SUSPENDED;
 * CURSOR_INVALID, and nothing changes; or the query's own status. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_contact_resume(
    flashbvh_first_contact_query* query, const flashbvh_contact_cursor* cursor);

#ifdef __cplusplus
}
#endif

#endif
