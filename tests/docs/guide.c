/* The guide's examples in C99. */
#include <flashbvh/clearance.h>
#include <flashbvh/ray.h>
#include <flashbvh/shape.h>

#include "peg.fbvh.h"
#include "plate.fbvh.h"

static const flashbvh_tree_size plate_tree = plate_TREE_SIZE;
static const flashbvh_tree_size peg_tree = peg_TREE_SIZE;
static flashbvh_mesh plate;
static flashbvh_mesh peg;
static uint32_t work;

/** Once, at reset. */
static bool start(void) {
  flashbvh_view_unchecked(plate_image, &plate);
  flashbvh_view_unchecked(peg_image, &peg);
  work = flashbvh_work_within_cycles(84000, &flashbvh_cortex_m4f_cycles, 0, &plate_tree, &peg_tree);
  return work != 0;
}

typedef enum verdict { PENDING, NO_CONTACT, STOP } verdict;

/** Whether surfaces intersect at the peg's target. The query points at the pose. */
typedef struct check {
  flashbvh_pose pose;
  flashbvh_query query;
  flashbvh_status status;
} check;

/** Errors of all three show in every run. */
static void check_start(check* c, const flashbvh_pose* plate_in_world, const float q[4],
                        const float at[3]) {
  (void)flashbvh_pose_of_quaternion(q, at, plate_CELLS_PER_UNIT, &c->pose);
  (void)flashbvh_pose_relative(plate_in_world, &c->pose, &c->pose);
  c->status = flashbvh_query_start(&c->query, &plate, &peg, &c->pose);
}

static verdict check_tick(check* c) {
  flashbvh_pair found[1];
  c->status = flashbvh_query_run(&c->query, work, found, 1).status;
  switch (c->status) {
    case FLASHBVH_STATUS_SUSPENDED:
      return PENDING; /* the next period goes on */
    case FLASHBVH_STATUS_DONE:
      return NO_CONTACT;
    default:
      return STOP; /* FULL: a pair was found; all others: an error */
  }
}

/** Where they touch, if the status is FULL, in mm of the plate's drawing. */
static void check_contact(const check* c, float mm[3]) {
  flashbvh_contact contact;
  flashbvh_query_last_contact(&c->query, &contact);
  flashbvh_in_unit(&contact.ends[0], &plate, mm);
}

/** How far the peg is from the plate, in mm; negative if unknown. */
static float distance_mm(const flashbvh_pose* pose, flashbvh_witness* nearest) {
  flashbvh_clearance known;
  if (flashbvh_distance(&plate, &peg, pose, nearest, &known) != FLASHBVH_STATUS_DONE) {
    return -1;
  }
  *nearest = known.witness;
  return flashbvh_length_in_unit(known.lower, &plate);
}

/** Once, and where it stays: the shape points into itself. */
static bool cable_start(flashbvh_segment_shape* axis) {
  const flashbvh_point p = {0, 0, 0};
  const flashbvh_point q = {0, 0, (int32_t)(20 * plate_CELLS_PER_UNIT)};
  return flashbvh_segment_shape_make(axis, &plate, &p, &q) == FLASHBVH_STATUS_DONE;
}

/** Also true if the query cannot decide. */
static bool cable_touches_plate(const flashbvh_segment_shape* axis, const flashbvh_pose* pose) {
  const uint32_t radius = flashbvh_fine_distance(2, plate_CELLS_PER_UNIT);
  bool yes = true;
  return flashbvh_closer_than(&plate, &axis->mesh, pose, radius, &yes) != FLASHBVH_STATUS_DONE ||
         yes;
}

/** How high a sensor is above the plate, in mm: `reach` if nothing is seen, 0 if unknown. */
static float height_seen(const float from[3], float reach) {
  const float down[3] = {0, 0, -1};
  flashbvh_segment ray;
  flashbvh_hit hit;
  bool yes = false;
  if (flashbvh_segment_of(from, down, reach, plate_CELLS_PER_UNIT, &ray) != FLASHBVH_STATUS_DONE ||
      flashbvh_nearest_hit(&plate, &ray, FLASHBVH_NO_HINT, &yes, &hit) != FLASHBVH_STATUS_DONE) {
    return 0;
  }
  return yes ? flashbvh_length_in_unit(flashbvh_distance_along(&ray, &hit), &plate) : reach;
}

static verdict verdict_at(float height, float mm[3]) {
  const float upright[4] = {1, 0, 0, 0};
  const float at[3] = {0, 0, height};
  flashbvh_pose world;
  check ahead;
  verdict answer = PENDING;
  (void)flashbvh_pose_translated(0, 0, 0, &world);
  check_start(&ahead, &world, upright, at);
  while (answer == PENDING) {
    answer = check_tick(&ahead);
  }
  if (ahead.status == FLASHBVH_STATUS_FULL) {
    check_contact(&ahead, mm);
  }
  return answer;
}

/** The cable touches the plate at 1.9 mm above it, not at 2.1 mm. */
static bool cable_is_right(void) {
  const int32_t low = (int32_t)(1.9f * plate_CELLS_PER_UNIT);
  const int32_t high = (int32_t)(2.1f * plate_CELLS_PER_UNIT);
  flashbvh_segment_shape axis;
  flashbvh_pose pose;
  bool touches;
  if (!cable_start(&axis)) {
    return false;
  }
  (void)flashbvh_pose_translated(0, 0, low, &pose);
  touches = cable_touches_plate(&axis, &pose);
  (void)flashbvh_pose_translated(0, 0, high, &pose);
  return touches && !cable_touches_plate(&axis, &pose);
}

/** Sensors 12 mm above the plate, and next to it. */
static bool ray_is_right(void) {
  const float above[3] = {30, 20, 12};
  const float beside[3] = {300, 20, 12};
  const float seen = height_seen(above, 100);
  return seen > 11.99f && seen < 12.01f && height_seen(beside, 100) == 100 &&
         height_seen(above, -1) == 0;
}

int main(void) {
  float mm[3] = {1, 1, 1};
  flashbvh_pose above;
  flashbvh_witness nearest = {0, 0};
  float apart;
  if (!start() || verdict_at(0.5f, mm) != NO_CONTACT || mm[2] < 1) {
    return 1;
  }
  (void)flashbvh_pose_translated(0, 0, (int32_t)(3 * plate_CELLS_PER_UNIT + 0.5f), &above);
  apart = distance_mm(&above, &nearest);
  if (apart < 2.99f || apart > 3.01f) {
    return 2;
  }
  if (!cable_is_right()) {
    return 3;
  }
  if (!ray_is_right()) {
    return 4;
  }
  return verdict_at(0, mm) == STOP && mm[2] > -0.01f && mm[2] < 0.01f ? 0 : 1;
}
