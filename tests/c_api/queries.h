/* Queries made in C, for tests that compare them. */
#ifndef FLASHBVH_TESTS_C_API_QUERIES_H
#define FLASHBVH_TESTS_C_API_QUERIES_H

#include <flashbvh/flashbvh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** All pairs of a query in its order, and what it did. */
typedef struct answer {
  flashbvh_pair* pairs;
  uint32_t room; /**< entries of `pairs`; more pairs are counted, not kept */
  uint32_t count;
  flashbvh_counts counts;
  flashbvh_status status;
} answer;

/** In runs of `work` into an array of `capacity`, at most 8. */
void query_in_slices(const flashbvh_mesh* a, const flashbvh_mesh* b, const flashbvh_pose* pose,
                     uint32_t work, uint32_t capacity, answer* to);

/** The same, with a new query after each run, taken to the position of the one before. */
void query_saved_and_resumed(const flashbvh_mesh* a, const flashbvh_mesh* b,
                             const flashbvh_pose* pose, uint32_t work, uint32_t capacity,
                             answer* to);

/** Whether status, count and pairs are the same. */
bool same_answer(const answer* one, const answer* other);

/** Whether all one-call questions are answered as by a query that gave `expected`, with at least
 * one pair or none, and DONE. */
bool questions_agree(const flashbvh_mesh* a, const flashbvh_mesh* b, const flashbvh_pose* pose,
                     const answer* expected);

#ifdef __cplusplus
}
#endif

#endif
