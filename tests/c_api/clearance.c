/* Distances in C: a blade 2.5 mm above a block, each a metre off its frame's origin, in
 * millimetres; in slices, saved, resumed, seeded, in one call. */
#include "flashbvh/clearance.h"
#include "flashbvh/ray.h"
#include "flashbvh/shape.h"
#include "flashbvh/solid.h"

#include <stddef.h>

#include "blade.fbvh.h"
#include "block.fbvh.h"
#include "clearance_failures.h"

static long failures;

static void check(bool holds) {
  failures += holds ? 0 : 1;
}

static bool near(float length, float wanted) {
  return length - wanted <= 0.1f / 256 && wanted - length <= 0.1f / 256;
}

static bool same(const flashbvh_clearance* p, const flashbvh_clearance* q) {
  return p->status == q->status && p->lower == q->lower && p->upper == q->upper &&
         p->point_a.x == q->point_a.x && p->point_a.y == q->point_a.y &&
         p->point_b.z == q->point_b.z && p->witness.a == q->witness.a &&
         p->witness.b == q->witness.b && p->in_range == q->in_range;
}

/** Out of range: bounds, and neither points nor a witness. The block's sides are 100 cells. */
static void check_far(const flashbvh_mesh* block) {
  flashbvh_pose pose;
  flashbvh_clearance found;
  const flashbvh_witness none = {UINT16_MAX, UINT16_MAX};
  (void)flashbvh_pose_translated(60100, 0, 0, &pose);
  check(flashbvh_distance(block, block, &pose, NULL, &found) == FLASHBVH_STATUS_DONE);
  check(!found.in_range && found.lower <= 60000 * 256 && found.upper >= 60000 * 256);
  check(found.upper < 60200 * 256 && found.point_a.x == 0 && found.point_b.x == 0);
  check(found.witness.a == none.a && found.witness.b == none.b && found.direction.x == 0);
  /* What it told of is no seed, and taken as none. */
  check(flashbvh_distance(block, block, &pose, &found.witness, &found) == FLASHBVH_STATUS_DONE);
}

static bool count_all(flashbvh_pair pair, void* context) {
  (void)pair;
  ++*(uint32_t*)context;
  return true;
}

static void check_slices(const flashbvh_mesh* a, const flashbvh_mesh* b, const flashbvh_pose* pose,
                         const flashbvh_clearance* wanted) {
  flashbvh_clearance_query query;
  flashbvh_clearance found;
  flashbvh_status status = flashbvh_clearance_start(&query, a, b, pose, NULL, 0);
  check(status == FLASHBVH_STATUS_SUSPENDED);
  while (status == FLASHBVH_STATUS_SUSPENDED) {
    flashbvh_clearance_query resumed;
    const flashbvh_clearance_position position = flashbvh_clearance_position_of(&query);
    uint32_t work = 3;
    (void)flashbvh_clearance_start(&resumed, a, b, pose, NULL, 0);
    check(flashbvh_clearance_resume(&resumed, &position) == FLASHBVH_STATUS_SUSPENDED);
    query = resumed;
    status = flashbvh_clearance_spend(&query, &work);
    check(work < 3);
  }
  flashbvh_clearance_result(&query, &found);
  check(same(&found, wanted));
}

/** A box wholly inside the block: no pair, and yet not free. */
static void check_contained(const flashbvh_mesh* block) {
  const flashbvh_point lower = {10040, 10040, 10040};
  const flashbvh_point upper = {10060, 10060, 10060};
  flashbvh_box_shape box;
  flashbvh_pose pose;
  uint32_t pairs = 1;
  bool yes = false;
  check(flashbvh_box_shape_make(&box, block, &lower, &upper) == FLASHBVH_STATUS_DONE);
  (void)flashbvh_pose_translated(0, 0, 0, &pose);
  check(flashbvh_count_pairs(block, &box.mesh, &pose, &pairs) == FLASHBVH_STATUS_DONE);
  check(pairs == 0);
  check(flashbvh_one_is_inside(block, &box.mesh, &pose, &yes) == FLASHBVH_STATUS_DONE && yes);
  yes = false;
  check(flashbvh_one_is_inside(&box.mesh, block, &pose, &yes) == FLASHBVH_STATUS_DONE && yes);
}

/** The block is closed, the blade isn't. */
static void check_solids(const flashbvh_mesh* block, const flashbvh_mesh* blade) {
  const flashbvh_point middle = {10050, 10050, 10050};
  const flashbvh_point corner = {10000, 10000, 10100};
  const flashbvh_point above = {10050, 10050, 10101};
  flashbvh_point_side side;
  flashbvh_pose pose;
  bool yes = false;
  check(flashbvh_inside(block, &middle, &side) == FLASHBVH_STATUS_DONE &&
        side == FLASHBVH_POINT_INSIDE);
  check(flashbvh_inside(block, &corner, &side) == FLASHBVH_STATUS_DONE &&
        side == FLASHBVH_POINT_ON_SURFACE);
  check(flashbvh_inside(block, &above, &side) == FLASHBVH_STATUS_DONE &&
        side == FLASHBVH_POINT_OUTSIDE);
  check(flashbvh_inside(blade, &middle, &side) == FLASHBVH_STATUS_NOT_CLOSED);
  (void)flashbvh_pose_translated(0, 0, 101, &pose);
  check(flashbvh_solids_intersect(block, block, &pose, &yes) == FLASHBVH_STATUS_DONE && !yes);
  yes = true;
  check(flashbvh_one_is_inside(block, block, &pose, &yes) == FLASHBVH_STATUS_DONE && !yes);
  (void)flashbvh_pose_translated(0, 0, 100, &pose);
  check(flashbvh_solids_intersect(block, block, &pose, &yes) == FLASHBVH_STATUS_DONE && yes);
  (void)flashbvh_pose_translated(0, 0, 0, &pose);
  check(flashbvh_solids_intersect(block, blade, &pose, &yes) == FLASHBVH_STATUS_NOT_CLOSED && yes);
  yes = false;
  check(flashbvh_one_is_inside(block, blade, &pose, &yes) == FLASHBVH_STATUS_NOT_CLOSED && yes);
  check_contained(block);
}

static bool count_front(const flashbvh_hit* hit, void* context) {
  *(uint32_t*)context += hit->side > 0 ? 1 : 0;
  return true;
}

/** Down through the block, 100 cells a side, from 50 cells above it; past it; and too far. */
static void check_rays(const flashbvh_mesh* block) {
  const float origin[3] = {1003, 1002, 1015};
  const float down[3] = {0, 0, -3};
  const flashbvh_segment past = {{10150, 10050, 10150}, {10150, 10050, 9000}};
  const flashbvh_segment far = {{10050, 10050, 10150}, {10050, 10050, 10050 - 600000}};
  flashbvh_segment ray = {{0, 0, 0}, {0, 0, 0}};
  flashbvh_fine_point at;
  flashbvh_hit hit;
  bool yes = false;
  uint32_t fronts = 0;
  int32_t outwards = 9;
  check(flashbvh_segment_of(origin, down, 30, 10, &ray) == FLASHBVH_STATUS_DONE);
  check(ray.from.x == 10030 && ray.from.z == 10150 && ray.to.y == 10020 && ray.to.z == 9850);
  check(flashbvh_nearest_hit(block, &ray, FLASHBVH_NO_SEED, &yes, &hit) == FLASHBVH_STATUS_DONE);
  check(yes && hit.side == 1);
  flashbvh_point_along(&ray, &hit, &at);
  check(at.x == 10030 * 256 && at.y == 10020 * 256 && at.z == 10100 * 256);
  check(flashbvh_distance_along(&ray, &hit) == 50 * 256);
  check(flashbvh_nearest_hit(block, &ray, hit.position, &yes, &hit) == FLASHBVH_STATUS_DONE && yes);
  check(flashbvh_for_each_hit(block, &ray, count_front, &fronts) == FLASHBVH_STATUS_DONE);
  check(fronts >= 1 && fronts <= 2);
  check(flashbvh_signed_crossings(block, &ray, &outwards) == FLASHBVH_STATUS_DONE && outwards == 0);
  ray.to.z = 10050;
  check(flashbvh_signed_crossings(block, &ray, &outwards) == FLASHBVH_STATUS_DONE &&
        outwards == -1);
  check(flashbvh_any_hit(block, &ray, &yes, &hit) == FLASHBVH_STATUS_DONE && yes);
  check(flashbvh_any_hit(block, &past, &yes, &hit) == FLASHBVH_STATUS_DONE && !yes);
  check(flashbvh_any_hit(block, &far, &yes, &hit) == FLASHBVH_STATUS_RAY_OUT_OF_RANGE && yes);
  check(flashbvh_segment_of(origin, down, -1, 10, &ray) == FLASHBVH_STATUS_RAY_OUT_OF_RANGE);
}

long clearance_failures(void) {
  const float upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const float above_block[3] = {2000, 2000, 2007.5f};
  const flashbvh_witness nobody = {0, 9999};
  flashbvh_mesh block;
  flashbvh_mesh blade;
  flashbvh_pose pose;
  flashbvh_clearance found;
  flashbvh_clearance seeded;
  flashbvh_clearance_query query;
  uint32_t work = 1000000;
  uint32_t pairs = 0;
  bool yes = false;
  float scale;
  float at[3];
  check(flashbvh_open(block_image, sizeof block_image, &block) == FLASHBVH_STATUS_DONE);
  check(flashbvh_open(blade_image, sizeof blade_image, &blade) == FLASHBVH_STATUS_DONE);
  scale = flashbvh_mesh_cells_per_unit(&block);
  check(flashbvh_pose_of_matrix(upright, above_block, scale, &pose) == FLASHBVH_STATUS_DONE);

  check(flashbvh_distance(&block, &blade, &pose, NULL, &found) == FLASHBVH_STATUS_DONE);
  check(found.in_range && found.lower == 25 * 256 && found.upper == 25 * 256);
  check(near(flashbvh_length_in_unit(found.lower, &block), 2.5f));
  flashbvh_in_unit(&found.point_a, &block, at);
  check(near(at[0], 1003.1f) && at[1] >= 1002 && at[1] <= 1006 && near(at[2], 1010));
  flashbvh_in_unit(&found.point_b, &block, at);
  check(near(at[0], 1003.1f) && near(at[2], 1012.5f));
  check(found.direction.x == 0 && found.direction.y == 0 && found.direction.z == FLASHBVH_UNIT_ONE);

  check(flashbvh_distance(&block, &blade, &pose, &found.witness, &seeded) == FLASHBVH_STATUS_DONE);
  check(same(&seeded, &found));
  check(flashbvh_distance(&block, &blade, &pose, &nobody, &seeded) == FLASHBVH_STATUS_SEED_INVALID);
  check_slices(&block, &blade, &pose, &found);
  check(flashbvh_clearance_start(&query, &block, &blade, &pose, &found.witness, 0) ==
        FLASHBVH_STATUS_SUSPENDED);
  check(flashbvh_clearance_spend(&query, &work) == FLASHBVH_STATUS_DONE);
  check(work < 1000000 && flashbvh_clearance_counts(&query).visits >= 1);

  check(flashbvh_closer_than(&block, &blade, &pose, flashbvh_fine_distance(2.5f, scale), &yes) ==
            FLASHBVH_STATUS_DONE &&
        yes);
  check(flashbvh_closer_than(&block, &blade, &pose, 25 * 256 - 1, &yes) == FLASHBVH_STATUS_DONE &&
        !yes);
  check(flashbvh_closer_than(&block, &blade, &pose, FLASHBVH_MAX_DISTANCE + 1, &yes) ==
            FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE &&
        yes);
  check(flashbvh_fine_distance(-1, scale) == UINT32_MAX);
  check(flashbvh_for_each_within(&block, &blade, &pose, 25 * 256, count_all, &pairs) ==
        FLASHBVH_STATUS_DONE);
  check(pairs >= 1 && pairs <= 2);
  check_far(&block);
  check_solids(&block, &blade);
  check_rays(&block);
  return failures;
}
