/* Bands in C: every pair of triangles within a distance, of a blade beside a block; in slices of
 * every size, saved, resumed, visited, and as C++ gives them. */
#include "within.h"

#include "blade.fbvh.h"
#include "block.fbvh.h"

enum { MOST_WORK = 130 }; /* a leaf's four pairs of triangles in one step, and a little */

static long failures;
/** What is asked about, in either order. */
typedef struct part {
  flashbvh_mesh mesh;
  image bytes;
} part;
static part block = {.bytes = {block_image, sizeof block_image}};
static part blade = {.bytes = {blade_image, sizeof blade_image}};
static const part* a;
static const part* b;
static band expected;

static void check(bool holds) {
  failures += holds ? 0 : 1;
}

static bool can_go_on(flashbvh_status status) {
  return status == FLASHBVH_STATUS_SUSPENDED || status == FLASHBVH_STATUS_FULL;
}

static bool same_pair(flashbvh_pair p, flashbvh_pair q) {
  return p.a == q.a && p.b == q.b;
}

static bool same_counts(flashbvh_counts p, flashbvh_counts q) {
  return p.visits == q.visits && p.overlaps == q.overlaps && p.leaf_pairs == q.leaf_pairs &&
         p.triangle_pairs == q.triangle_pairs;
}

static bool same_point(const flashbvh_fine_point* p, const flashbvh_fine_point* q) {
  return p->x == q->x && p->y == q->y && p->z == q->z;
}

static bool same_nearest(const flashbvh_nearest_points* p, const flashbvh_nearest_points* q) {
  return same_point(&p->point_a, &q->point_a) && same_point(&p->point_b, &q->point_b) &&
         p->direction.x == q->direction.x && p->direction.y == q->direction.y &&
         p->direction.z == q->direction.z && p->lower == q->lower && p->upper == q->upper;
}

/** Where the pair reported last is nearest, told in both ways. */
static void check_last(const flashbvh_within_query* query, uint32_t i) {
  flashbvh_nearest_points nearest;
  flashbvh_triangle of_a;
  flashbvh_triangle of_b;
  flashbvh_within_last_nearest_points(query, &nearest);
  check(same_nearest(&nearest, &expected.nearest[i]));
  flashbvh_within_last_pair(query, &of_a, &of_b);
  flashbvh_nearest_points_of(&of_a, &of_b, &nearest);
  check(same_nearest(&nearest, &expected.nearest[i]));
}

/** Runs of so much work into an array of `capacity`, at most 3. */
static void check_slices(const flashbvh_pose* pose, uint32_t distance, uint32_t work,
                         uint32_t capacity) {
  flashbvh_within_query query;
  flashbvh_pair found[3];
  flashbvh_status status;
  uint32_t done = 0;
  uint32_t count = 0;
  (void)flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, distance);
  do {
    status = flashbvh_within_run(&query, work, found, capacity, &count);
    for (uint32_t i = 0; i < count && done < expected.count; ++i, ++done) {
      check(same_pair(found[i], expected.pairs[done]));
    }
    if (status == FLASHBVH_STATUS_FULL && done != 0) {
      check_last(&query, done - 1);
    }
  } while (can_go_on(status));
  check(status == FLASHBVH_STATUS_DONE && done == expected.count);
  check(same_counts(flashbvh_within_counts(&query), expected.counts));
}

/** A new query after each run, taken to the position of the one before. */
static void check_resumed(const flashbvh_pose* pose, uint32_t distance, uint32_t work) {
  flashbvh_within_query query;
  flashbvh_pair found[1];
  flashbvh_status status;
  uint32_t done = 0;
  uint32_t count = 0;
  (void)flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, distance);
  do {
    uint32_t left = work;
    status = flashbvh_within_spend(&query, &left, found, 1, &count);
    check(left < work || count != 0 || status == FLASHBVH_STATUS_DONE);
    if (count != 0) {
      check(done < expected.count && same_pair(found[0], expected.pairs[done]));
      ++done;
    }
    if (can_go_on(status)) {
      const flashbvh_position position = flashbvh_within_position(&query);
      (void)flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, distance);
      check(flashbvh_within_resume(&query, &position) == flashbvh_within_status(&query));
    }
  } while (can_go_on(status));
  check(status == FLASHBVH_STATUS_DONE && done == expected.count);
}

/** Takes pairs as long as they are those expected. */
static bool take_next(flashbvh_pair pair, void* context) {
  uint32_t* const done = context;
  return *done < expected.count && same_pair(pair, expected.pairs[(*done)++]);
}

static void check_visited(const flashbvh_pose* pose, uint32_t distance) {
  flashbvh_within_query query;
  flashbvh_status status;
  uint32_t done = 0;
  check(flashbvh_for_each_within(&a->mesh, &b->mesh, pose, distance, take_next, &done) ==
        FLASHBVH_STATUS_DONE);
  check(done == expected.count);
  done = 0;
  (void)flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, distance);
  do {
    uint32_t work = 40;
    status = flashbvh_within_visit(&query, &work, take_next, &done);
  } while (status == FLASHBVH_STATUS_SUSPENDED);
  check(status == FLASHBVH_STATUS_DONE && done == expected.count);
}

static void check_band(const part* first, const part* second, const flashbvh_pose* pose,
                       uint32_t distance) {
  a = first;
  b = second;
  band_in_cpp(a->bytes, b->bytes, pose, distance, &expected);
  check(expected.status == FLASHBVH_STATUS_DONE && expected.count <= BAND_ROOM);
  for (uint32_t i = 0; i < expected.count; ++i) {
    check(expected.nearest[i].lower <= distance);
  }
  check_visited(pose, distance);
  for (uint32_t work = 1; work <= MOST_WORK; ++work) {
    check_slices(pose, distance, work, 1 + work % 3);
    check_resumed(pose, distance, work);
  }
  check_slices(pose, distance, UINT32_MAX, 1);
}

/** What is refused is refused by every run, and no pair is given. */
static void check_refused(const flashbvh_pose* pose) {
  const flashbvh_position nowhere = {9999, 0, 0, 1, {0, 0, 0}};
  flashbvh_within_query query;
  flashbvh_pair found[1];
  uint32_t work = 10;
  uint32_t count = 1;
  check(flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, FLASHBVH_MAX_DISTANCE + 1) ==
        FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(flashbvh_within_run(&query, 10, found, 1, &count) == FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(flashbvh_within_spend(&query, &work, found, 1, &count) ==
        FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(count == 0 && work == 10);
  check(flashbvh_within_start(&query, &a->mesh, &b->mesh, pose, FLASHBVH_MAX_DISTANCE) ==
        FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_within_run(&query, 10, found, 0, &count) == FLASHBVH_STATUS_FULL && count == 0);
  check(flashbvh_within_resume(&query, &nowhere) == FLASHBVH_STATUS_POSITION_INVALID);
  check(flashbvh_within_status(&query) == FLASHBVH_STATUS_SUSPENDED);
}

/** Pose i: the blade's middle above the block, or on its upper face; upright, or turned by 36.87
 * degrees about x. */
static void pose_blade(int i, flashbvh_pose* pose) {
  const float rotations[2][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                 {1, 0, 0, 0, 0.8f, -0.6f, 0, 0.6f, 0.8f}};
  const float* const r = rotations[i % 2];
  const float middle[3] = {1003, 1004, i < 2 ? 1017.5f : 1010};
  const float drawn[3] = {-996.9f, -996, -990};
  float to[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float* const row = r + 3 * axis;
    to[axis] = middle[axis] - (row[0] * drawn[0] + row[1] * drawn[1] + row[2] * drawn[2]);
  }
  check(flashbvh_pose_of_matrix(r, to, flashbvh_mesh_cells_per_unit(&block.mesh), pose) ==
        FLASHBVH_STATUS_DONE);
}

long within_failures(void) {
  const uint32_t distances[] = {0, 25 * 256, 60 * 256, 400 * 256};
  uint32_t total = 0;
  check(flashbvh_open(block.bytes.bytes, block.bytes.size, &block.mesh) == FLASHBVH_STATUS_DONE);
  check(flashbvh_open(blade.bytes.bytes, blade.bytes.size, &blade.mesh) == FLASHBVH_STATUS_DONE);
  for (int i = 0; i < 4; ++i) {
    flashbvh_pose pose;
    flashbvh_pose back;
    pose_blade(i, &pose);
    check(flashbvh_pose_inverse(&pose, &back) == FLASHBVH_STATUS_DONE);
    for (size_t k = 0; k < sizeof distances / sizeof distances[0]; ++k) {
      check_band(&blade, &block, &back, distances[k]);
      total += expected.count;
      check_band(&block, &blade, &pose, distances[k]);
      total += expected.count;
    }
    check_refused(&pose);
  }
  check(total > 120);
  return failures;
}
