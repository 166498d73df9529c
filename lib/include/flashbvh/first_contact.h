/* flashbvh for C: whether two bodies are apart at every moment of a motion. body_motion.hpp and
 * first_contact.hpp say what a motion is, and what is certified.
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

/** The end of a motion. A time is a binary fraction of it, 0 its begin. */
#define FLASHBVH_MOTION_END ((uint32_t)1 << 30)

/** BodyMotion: constant once made, and shared by any number of queries. An error is kept in it, and
 * every query on it returns it. 188 bytes on a 32-bit core, 192 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_body_motion, 1, 184, uint32_t);

/** The most moves of a motion that a query takes. */
#define FLASHBVH_MOST_MOVES 64

/** BodyMotion::between(): straight, and by the shorter turn. MOTION_OUT_OF_RANGE; NOT_A_ROTATION
 * and TRANSLATION_OUT_OF_RANGE of the poses. */
flashbvh_status flashbvh_body_motion_between(const flashbvh_pose* from, const flashbvh_pose* to,
                                             flashbvh_body_motion* motion);

/** BodyMotion: `count` moves from the outermost to the innermost, which outlive the motion.
 * Statuses as above; NOT_A_ROTATION also of an axis whose length is not 1. */
flashbvh_status flashbvh_body_motion_of_moves(const flashbvh_pose* from, const flashbvh_move* moves,
                                              uint32_t count, flashbvh_body_motion* motion);

/** BodyMotion::pose_at(): `time` up to FLASHBVH_MOTION_END. TRANSLATION_OUT_OF_RANGE of a motion in
 * error. */
flashbvh_status flashbvh_body_motion_pose(const flashbvh_body_motion* motion, uint32_t time,
                                          flashbvh_pose* pose);

/** FirstContact, and all its memory. 80 bytes on a 32-bit core, 96 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_first_contact_query, 3, 68, uint32_t);

/** FirstContactCursor: where a query stands between runs, not the caller's to read. May be stored
 * for any time, as bytes too. */
FLASHBVH_OPAQUE(flashbvh_contact_cursor, 0, 36, uint32_t);

/** Starts a query; meshes and motion outlive it. Bodies within `within`, in 1/256 cell, touch; 0:
 * bodies that intersect. SUSPENDED if there is something to run. The motion's status;
 * MOTION_OUT_OF_RANGE, also of too many moves; DISTANCE_OUT_OF_RANGE: beyond FLASHBVH_MAX_DISTANCE
 * / 2. Every run returns the status again, or CELL_MISMATCH. */
flashbvh_status flashbvh_first_contact_start(flashbvh_first_contact_query* query,
                                             const flashbvh_mesh* a, const flashbvh_mesh* b,
                                             const flashbvh_body_motion* motion, uint32_t within);

/** FirstContact::run(): at most `work`, overdrawn by one step; UINT32_MAX is all. */
FLASHBVH_NODISCARD flashbvh_first_contact_answer
flashbvh_first_contact_run(flashbvh_first_contact_query* query, uint32_t work);

/** FirstContact::pass(): goes on behind an answer CLOSE, as if it were free. */
void flashbvh_first_contact_pass(flashbvh_first_contact_query* query);

/** FirstContact::cursor(), between runs. */
flashbvh_contact_cursor flashbvh_first_contact_cursor(const flashbvh_first_contact_query* query);

/** FirstContact::resume(), of a started query. SUSPENDED; CURSOR_INVALID, and nothing changes; or
 * the query's own status. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_first_contact_resume(
    flashbvh_first_contact_query* query, const flashbvh_contact_cursor* cursor);

#ifdef __cplusplus
}
#endif

#endif
