#include "queries.h"

#include <string.h>

enum { MOST_PAIRS_A_RUN = 8 };

static void keep(answer* to, const flashbvh_pair* pairs, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i, ++to->count) {
    if (to->count < to->room) {
      to->pairs[to->count] = pairs[i];
    }
  }
}

static void add_counts(flashbvh_counts* sum, flashbvh_counts more) {
  sum->visits += more.visits;
  sum->overlaps += more.overlaps;
  sum->leaf_pairs += more.leaf_pairs;
  sum->triangle_pairs += more.triangle_pairs;
}

static bool can_go_on(flashbvh_status status) {
  return status == FLASHBVH_STATUS_SUSPENDED || status == FLASHBVH_STATUS_FULL;
}

static void clear(answer* to) {
  to->count = 0;
  memset(&to->counts, 0, sizeof to->counts);
}

/* One run, whose pairs are kept. */
static void run_once(flashbvh_query* query, uint32_t work, uint32_t capacity, answer* to) {
  flashbvh_pair found[MOST_PAIRS_A_RUN];
  uint32_t count = UINT32_MAX;
  to->status = flashbvh_query_run(query, work, found, capacity, &count);
  keep(to, found, count);
}

void query_in_slices(const flashbvh_mesh* a, const flashbvh_mesh* b, const flashbvh_pose* pose,
                     uint32_t work, uint32_t capacity, answer* to) {
  flashbvh_query query;
  clear(to);
  flashbvh_query_start(&query, a, b, pose);
  do {
    run_once(&query, work, capacity, to);
  } while (can_go_on(to->status));
  to->counts = flashbvh_query_counts(&query);
}

void query_saved_and_resumed(const flashbvh_mesh* a, const flashbvh_mesh* b,
                             const flashbvh_pose* pose, uint32_t work, uint32_t capacity,
                             answer* to) {
  unsigned char saved[sizeof(flashbvh_position)];
  flashbvh_query query;
  clear(to);
  flashbvh_query_start(&query, a, b, pose);
  do {
    run_once(&query, work, capacity, to);
    add_counts(&to->counts, flashbvh_query_counts(&query));
    if (can_go_on(to->status)) {
      flashbvh_position position = flashbvh_query_position(&query);
      memcpy(saved, &position, sizeof saved);
      memset(&query, 0xA5, sizeof query);
      memset(&position, 0xA5, sizeof position);
      flashbvh_query_start(&query, a, b, pose);
      memcpy(&position, saved, sizeof saved);
      const flashbvh_status resumed = flashbvh_query_resume(&query, &position);
      to->status = resumed == FLASHBVH_STATUS_SUSPENDED ? to->status : resumed;
    }
  } while (can_go_on(to->status));
}

static bool same_pair(flashbvh_pair one, flashbvh_pair other) {
  return one.a == other.a && one.b == other.b;
}

static bool same_counts(const flashbvh_counts* one, const flashbvh_counts* other) {
  return one->visits == other->visits && one->overlaps == other->overlaps &&
         one->leaf_pairs == other->leaf_pairs && one->triangle_pairs == other->triangle_pairs;
}

bool same_answer(const answer* one, const answer* other) {
  if (one->status != other->status || one->count != other->count || one->count > one->room ||
      one->count > other->room || !same_counts(&one->counts, &other->counts)) {
    return false;
  }
  for (uint32_t i = 0; i < one->count; ++i) {
    if (!same_pair(one->pairs[i], other->pairs[i])) {
      return false;
    }
  }
  return true;
}

/** What a visitor compares with. */
typedef struct visit_state {
  const answer* expected;
  uint32_t visited;
  uint32_t most;
  bool same;
} visit_state;

static bool compare_pair(flashbvh_pair pair, void* context) {
  visit_state* const state = context;
  state->same = state->same && state->visited < state->expected->count &&
                same_pair(pair, state->expected->pairs[state->visited]);
  ++state->visited;
  return state->visited < state->most;
}

static bool visitors_agree(const flashbvh_mesh* a, const flashbvh_mesh* b,
                           const flashbvh_pose* pose, const answer* expected) {
  visit_state all = {expected, 0, UINT32_MAX, true};
  visit_state first = {expected, 0, 1, true};
  return flashbvh_for_each_pair(a, b, pose, compare_pair, &all) == FLASHBVH_STATUS_DONE &&
         all.same && all.visited == expected->count &&
         flashbvh_for_each_pair(a, b, pose, compare_pair, &first) ==
             (expected->count != 0 ? FLASHBVH_STATUS_FULL : FLASHBVH_STATUS_DONE) &&
         first.same && first.visited == (expected->count != 0 ? 1u : 0u);
}

static bool found_pairs_agree(const flashbvh_mesh* a, const flashbvh_mesh* b,
                              const flashbvh_pose* pose, const answer* expected) {
  flashbvh_pair found[3];
  uint32_t count = UINT32_MAX;
  const flashbvh_status status = flashbvh_find_pairs(a, b, pose, found, 3, &count);
  bool agree = status == (expected->count < 3 ? FLASHBVH_STATUS_DONE : FLASHBVH_STATUS_FULL) &&
               count == (expected->count < 3 ? expected->count : 3u);
  for (uint32_t i = 0; agree && i < count; ++i) {
    agree = same_pair(found[i], expected->pairs[i]);
  }
  return agree;
}

bool questions_agree(const flashbvh_mesh* a, const flashbvh_mesh* b, const flashbvh_pose* pose,
                     const answer* expected) {
  const flashbvh_pair untouched = {0xABCD, 0xDCBA};
  const bool any = expected->count != 0;
  bool yes = !any;
  bool first_yes = !any;
  flashbvh_pair first = untouched;
  uint32_t pairs = UINT32_MAX;
  return flashbvh_intersects(a, b, pose, &yes) == FLASHBVH_STATUS_DONE && yes == any &&
         flashbvh_first_pair(a, b, pose, &first_yes, &first) == FLASHBVH_STATUS_DONE &&
         first_yes == any && same_pair(first, any ? expected->pairs[0] : untouched) &&
         flashbvh_count_pairs(a, b, pose, &pairs) == FLASHBVH_STATUS_DONE &&
         pairs == expected->count && found_pairs_agree(a, b, pose, expected) &&
         visitors_agree(a, b, pose, expected);
}
