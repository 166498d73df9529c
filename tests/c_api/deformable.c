/* A mesh that bends, in C: a block one of whose corners is pulled through its other side. */
#include "deformable.h"

#include <string.h>

#include "block.fbvh.h"
#include "flashbvh/clearance.h"
#include "flashbvh/deformable.h"

enum { MOST = 32, MOST_NODES = 16, VERTICES = 8 };

static long failures;
static flashbvh_node nodes[MOST_NODES];
static flashbvh_vertex vertices[VERTICES];

static void check(bool holds) {
  failures += holds ? 0 : 1;
}

static flashbvh_status refit(flashbvh_deformable* block) {
  uint32_t vertex = 0;
  return flashbvh_deformable_refit(block, UINT32_MAX, &vertex);
}

/** All pairs, in runs of `work`, each in a new object. */
static uint32_t find(const flashbvh_deformable* block, uint32_t work, flashbvh_pair pairs[MOST]) {
  uint32_t found = 0;
  flashbvh_self_position position;
  flashbvh_status status = FLASHBVH_STATUS_SUSPENDED;
  memset(&position, 0, sizeof position);
  position.refits = flashbvh_deformable_refits(block);
  while (status == FLASHBVH_STATUS_SUSPENDED) {
    flashbvh_self_query query;
    uint32_t count = 0;
    check(flashbvh_self_query_start(&query, block) == FLASHBVH_STATUS_SUSPENDED);
    check(flashbvh_self_query_resume(&query, &position) == FLASHBVH_STATUS_SUSPENDED);
    status = flashbvh_self_query_run(&query, work, pairs + found, MOST - found, &count);
    found += count;
    position = flashbvh_self_query_position(&query);
  }
  check(status == FLASHBVH_STATUS_DONE);
  return found;
}

/** The same of pairs within a distance. */
static uint32_t find_near(const flashbvh_deformable* block, uint32_t distance, uint32_t work,
                          flashbvh_pair pairs[MOST]) {
  uint32_t found = 0;
  flashbvh_self_position position;
  flashbvh_status status = FLASHBVH_STATUS_SUSPENDED;
  memset(&position, 0, sizeof position);
  position.refits = flashbvh_deformable_refits(block);
  while (status == FLASHBVH_STATUS_SUSPENDED) {
    flashbvh_self_within_query query;
    uint32_t count = 0;
    check(flashbvh_self_within_start(&query, block, distance) == FLASHBVH_STATUS_SUSPENDED);
    check(flashbvh_self_within_resume(&query, &position) == FLASHBVH_STATUS_SUSPENDED);
    status = flashbvh_self_within_run(&query, work, pairs + found, MOST - found, &count);
    check(work == 1 || flashbvh_self_within_counts(&query).visits != 0);
    found += count;
    position = flashbvh_self_within_position(&query);
  }
  check(status == FLASHBVH_STATUS_DONE);
  return found;
}

static void check_pairs(flashbvh_deformable* block) {
  flashbvh_pair whole[MOST];
  flashbvh_pair cut[MOST];
  bool yes = true;
  check(find(block, UINT32_MAX, whole) == 0);
  check(flashbvh_intersects_itself(&block->mesh, &yes) == FLASHBVH_STATUS_DONE && !yes);

  vertices[0].x = (int16_t)(-3 * vertices[0].x);
  vertices[0].y = (int16_t)(-3 * vertices[0].y / 2);
  check(refit(block) == FLASHBVH_STATUS_DONE);
  const uint32_t count = find(block, UINT32_MAX, whole);
  check(count != 0 && count < MOST);
  check(find(block, 1, cut) == count && memcmp(whole, cut, count * sizeof *cut) == 0);
  check(flashbvh_intersects_itself(&block->mesh, &yes) == FLASHBVH_STATUS_DONE && yes);
  check(find_near(block, 0, UINT32_MAX, whole) == count);
  const uint32_t near = find_near(block, FLASHBVH_MAX_DISTANCE, UINT32_MAX, whole);
  check(near > count && near < MOST);
  check(find_near(block, FLASHBVH_MAX_DISTANCE, 1, cut) == near);
  check(memcmp(whole, cut, near * sizeof *cut) == 0);
}

static void check_refusals(flashbvh_deformable* block, const flashbvh_mesh* baked) {
  flashbvh_self_query query;
  flashbvh_self_within_query band;
  flashbvh_pair pairs[MOST];
  flashbvh_pose pose;
  uint32_t count = 1;
  uint32_t vertex = 0;
  bool yes = false;
  const uint32_t refits = flashbvh_deformable_refits(block);
  check(flashbvh_self_query_start(&query, block) == FLASHBVH_STATUS_SUSPENDED);
  const flashbvh_self_position position = flashbvh_self_query_position(&query);
  check(flashbvh_self_within_start(&band, block, FLASHBVH_MAX_DISTANCE + 1) ==
        FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE);
  check(flashbvh_self_within_start(&band, block, 0) == FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_deformable_refit(block, 1, &vertex) == FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_deformable_refits(block) == refits + 1);
  (void)flashbvh_pose_translated(0, 0, 0, &pose);
  check(flashbvh_intersects(&block->mesh, baked, &pose, &yes) == FLASHBVH_STATUS_CELL_MISMATCH);
  check(refit(block) == FLASHBVH_STATUS_DONE);
  check(flashbvh_self_query_run(&query, 9, pairs, MOST, &count) == FLASHBVH_STATUS_MESH_CHANGED);
  check(count == 0);
  check(flashbvh_self_within_run(&band, 9, pairs, MOST, &count) == FLASHBVH_STATUS_MESH_CHANGED);
  check(flashbvh_self_query_start(&query, block) == FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_self_query_resume(&query, &position) == FLASHBVH_STATUS_MESH_CHANGED);
  check(flashbvh_self_within_start(&band, block, 0) == FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_self_within_resume(&band, &position) == FLASHBVH_STATUS_MESH_CHANGED);

  vertices[5].z = 16384;
  check(flashbvh_deformable_refit(block, UINT32_MAX, &vertex) ==
        FLASHBVH_STATUS_VERTEX_OUT_OF_LATTICE);
  check(vertex == 5);
}

long deformable_failures(void) {
  flashbvh_mesh baked;
  flashbvh_deformable block;
  check(flashbvh_open(block_image, sizeof block_image, &baked) == FLASHBVH_STATUS_DONE);
  check(flashbvh_mesh_nodes(&baked) <= MOST_NODES && flashbvh_mesh_vertices(&baked) == VERTICES);
  flashbvh_deformable_make(&block, &baked, nodes, vertices);
  check_pairs(&block);
  check_refusals(&block, &baked);
  return failures;
}
