/* A program in C that opens images, asks queries under rotation in slices of every kind, saves and
 * restores them, and compares all of it with C++. */
#include <string.h>

#include "blade.fbvh.h"
#include "block.fbvh.h"
#include "clearance_failures.h"
#include "deformable.h"
#include "peg.fbvh.h"
#include "plate.fbvh.h"
#include "queries.h"
#include "reference.h"
#include "shapes.h"
#include "text.h"
#include "within.h"

enum { ROOM = 200, POSES = 60 };

static long failures;
static uint32_t total;
static uint32_t rotated;

static void check(bool holds, const char* what, long where) {
  if (!holds) {
    ++failures;
    port_put(what);
    port_put(", pose ");
    port_put_number(where);
    port_put("\n");
  }
}

/** `one` and `other` at every way to cut their query, against C++. */
static void compare(image one, image other, const flashbvh_pose* pose, long where) {
  static flashbvh_pair expected_pairs[ROOM];
  static flashbvh_pair pairs[ROOM];
  static const uint32_t runs[] = {1, 3, 10, UINT32_MAX};
  static const uint32_t capacities[] = {1, 8};
  answer expected = {expected_pairs, ROOM, 0, {0, 0, 0, 0}, FLASHBVH_STATUS_DONE};
  answer got = {pairs, ROOM, 0, {0, 0, 0, 0}, FLASHBVH_STATUS_DONE};
  flashbvh_mesh a;
  flashbvh_mesh b;
  int32_t rotation[9];
  int32_t cells[3];
  int16_t fraction[3];
  check(flashbvh_open(one.bytes, one.size, &a) == FLASHBVH_STATUS_DONE, "open a", where);
  check(flashbvh_open(other.bytes, other.size, &b) == FLASHBVH_STATUS_DONE, "open b", where);
  flashbvh_pose_values(pose, rotation, cells, fraction);
  query_in_cpp(one, other, rotation, cells, fraction, &expected);
  total += expected.count;
  rotated += expected.count != 0 && rotation[0] != FLASHBVH_ROTATION_ONE ? 1u : 0u;
  check(expected.status == FLASHBVH_STATUS_DONE, "C++", where);
  for (size_t i = 0; i < sizeof runs / sizeof runs[0]; ++i) {
    for (size_t j = 0; j < sizeof capacities / sizeof capacities[0]; ++j) {
      query_in_slices(&a, &b, pose, runs[i], capacities[j], &got);
      check(same_answer(&got, &expected), "slices", where);
      query_saved_and_resumed(&a, &b, pose, runs[i], capacities[j], &got);
      check(same_answer(&got, &expected), "save and resume", where);
    }
  }
  check(questions_agree(&a, &b, pose, &expected), "questions", where);
}

/** Pose number i: rotated by 36.87 degrees (3/5, 4/5) about each axis in turn, and translated a
 * little, again and again. */
static void next_pose(int i, flashbvh_pose* pose) {
  const int32_t s = FLASHBVH_ROTATION_ONE / 5 * 3;
  const int32_t c = FLASHBVH_ROTATION_ONE / 5 * 4;
  const int32_t one = FLASHBVH_ROTATION_ONE;
  const int32_t rotations[3][9] = {{one, 0, 0, 0, c, -s, 0, s, c},
                                   {c, 0, s, 0, one, 0, -s, 0, c},
                                   {c, -s, 0, s, c, 0, 0, 0, one}};
  const int32_t cells[3] = {7 * (i % 5) - 14, 5 * (i % 7) - 15, 3 * (i % 4) - 5};
  const int16_t fraction[3] = {(int16_t)(1000 * (i % 9)), -32768, 32767};
  flashbvh_pose step;
  check(flashbvh_pose_rigid(rotations[i % 3], cells, fraction, &step) == FLASHBVH_STATUS_DONE,
        "rigid", i);
  check(flashbvh_pose_composed(&step, pose, pose) == FLASHBVH_STATUS_DONE, "composed", i);
}

static void check_poses(void) {
  flashbvh_pose pose;
  flashbvh_pose back;
  flashbvh_pose identity;
  int32_t rotation[9];
  int32_t cells[3];
  flashbvh_pose_translated(3, -4, 5, &pose);
  flashbvh_pose_values(&pose, rotation, cells, NULL);
  check(cells[0] == 3 && cells[1] == -4 && cells[2] == 5 && rotation[0] == FLASHBVH_ROTATION_ONE &&
            rotation[1] == 0,
        "translated", 0);
  next_pose(1, &pose);
  back = pose;
  check(flashbvh_pose_inverse(&back, &back) == FLASHBVH_STATUS_DONE, "inverse", 1);
  check(flashbvh_pose_composed(&back, &pose, &identity) == FLASHBVH_STATUS_DONE, "to itself", 1);
  flashbvh_pose_values(&identity, NULL, cells, NULL);
  check(cells[0] == 0 && cells[1] == 0 && cells[2] == 0, "there and back", 1);
  check(flashbvh_pose_relative(&pose, &pose, &pose) == FLASHBVH_STATUS_DONE, "relative", 1);
  check(flashbvh_pose_status(&pose) == FLASHBVH_STATUS_DONE, "status", 1);
  flashbvh_pose_values(&pose, NULL, cells, NULL);
  check(cells[0] == 0 && cells[1] == 0 && cells[2] == 0, "relative to itself", 1);
}

static void check_sizes(void) {
  const bool wide = sizeof(void*) == 8;
  check(sizeof(flashbvh_position) == 12, "size of a position", 0);
  check(sizeof(flashbvh_pose) == 68, "size of a pose", 0);
  check(sizeof(flashbvh_mesh) == (wide ? 88 : 64), "size of a mesh", 0);
  check(sizeof(flashbvh_query) == (wide ? 152 : 128), "size of a query", 0);
}

static float least(float u, float v) {
  return u < v ? u : v;
}
static float most(float u, float v) {
  return u < v ? v : u;
}
static bool near(float length, float wanted, float cell) {
  return length - wanted <= cell / 256 && wanted - length <= cell / 256;
}

/** The blade stands in the block's upper face, from (1003.1, 1003, 1010) to (1003.1, 1005, 1010)
 * mm of the block's frame, as it was drawn. */
static void check_contact(void) {
  const float upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const float to_block[3] = {2000, 2000, 2000};
  const float cell = 0.1f;
  flashbvh_mesh block;
  flashbvh_mesh blade;
  flashbvh_pose pose;
  flashbvh_query query;
  flashbvh_pair found[1];
  uint32_t count = 0;
  int32_t origin[3];
  float low = 2000;
  float high = 0;
  check(flashbvh_open(block_image, sizeof block_image, &block) == FLASHBVH_STATUS_DONE, "block", 0);
  check(flashbvh_open(blade_image, sizeof blade_image, &blade) == FLASHBVH_STATUS_DONE, "blade", 0);
  check(flashbvh_mesh_unit(&block) == FLASHBVH_UNIT_MM, "unit", 0);
  check(flashbvh_mesh_is_closed(&block) && !flashbvh_mesh_is_closed(&blade), "closed", 0);
  flashbvh_mesh_origin(&block, origin);
  check(origin[0] == 10050 && origin[1] == 10050 && origin[2] == 10050, "origin", 0);
  check(flashbvh_pose_of_matrix(upright, to_block, flashbvh_mesh_cells_per_unit(&block), &pose) ==
            FLASHBVH_STATUS_DONE,
        "pose of floats", 0);
  flashbvh_query_start(&query, &block, &blade, &pose);
  while (flashbvh_query_run(&query, UINT32_MAX, found, 1, &count) == FLASHBVH_STATUS_FULL) {
    flashbvh_contact contact;
    flashbvh_query_last_contact(&query, &contact);
    for (int end = 0; end < 2; ++end) {
      float at[3];
      int64_t nanometres[3];
      flashbvh_in_unit(&contact.ends[end], &block, at);
      flashbvh_in_millionths(&contact.ends[end], &block, nanometres);
      check(near(at[0], 1003.1f, cell) && near(at[2], 1010, cell), "contact in mm", end);
      check(nanometres[0] == 1003100000 && nanometres[2] == 1010000000, "contact in nm", end);
      low = least(low, at[1]);
      high = most(high, at[1]);
    }
    check(contact.kind == FLASHBVH_CONTACT_SEGMENT && contact.normal_b.y == 0, "contact", 0);
  }
  check(near(low, 1003, cell) && near(high, 1005, cell), "contact's ends in mm", 0);
}

static bool same_point(const flashbvh_point* p, const flashbvh_point* q) {
  return p->x == q->x && p->y == q->y && p->z == q->z;
}

/** Counts pairs until there are three. */
static bool count_to_three(flashbvh_pair pair, void* context) {
  (void)pair;
  return ++*(uint32_t*)context < 3;
}

/** The other ways to run a query and to ask for a contact: each says what the usual one says. */
static void check_other_ways(const image* one, const image* other) {
  const float turned[4] = {0.8f, 0, 0.6f, 0};
  const float nowhere[3] = {0, 0, 0};
  flashbvh_mesh a;
  flashbvh_mesh b;
  flashbvh_pose pose;
  flashbvh_query query;
  flashbvh_query visited;
  flashbvh_pair found[3];
  flashbvh_triangle of_a;
  flashbvh_triangle of_b;
  flashbvh_triangle again_a;
  flashbvh_triangle again_b;
  flashbvh_contact contact;
  flashbvh_contact again;
  uint32_t count = 0;
  uint32_t seen = 0;
  uint32_t work = 100000;
  uint32_t work_left = work;
  check(flashbvh_open(one->bytes, one->size, &a) == FLASHBVH_STATUS_DONE, "open a", 1);
  check(flashbvh_open(other->bytes, other->size, &b) == FLASHBVH_STATUS_DONE, "open b", 1);
  check(flashbvh_pose_of_quaternion(turned, nowhere, 1, &pose) == FLASHBVH_STATUS_DONE,
        "quaternion", 0);
  flashbvh_query_start(&query, &a, &b, &pose);
  flashbvh_query_start(&visited, &a, &b, &pose);
  check(flashbvh_query_spend(&query, &work, found, 3, &count) == FLASHBVH_STATUS_FULL, "spend", 0);
  check(flashbvh_query_visit(&visited, &work_left, count_to_three, &seen) == FLASHBVH_STATUS_FULL,
        "visit", 0);
  check(count == 3 && seen == 3 && work < 100000 && work_left <= work, "work left", (long)work);
  flashbvh_query_last_pair(&query, &of_a, &of_b);
  check(flashbvh_transform_pair(&a, &b, &pose, found[2], &again_a, &again_b), "pair", 2);
  for (int i = 0; i < 3; ++i) {
    check(same_point(&of_a.corner[i], &again_a.corner[i]) &&
              same_point(&of_b.corner[i], &again_b.corner[i]),
          "the triangles of a pair", i);
  }
  flashbvh_query_last_contact(&query, &contact);
  flashbvh_contact_of(&again_a, &again_b, &again);
  check(contact.kind == again.kind && contact.ends[0].x == again.ends[0].x &&
            contact.ends[1].z == again.ends[1].z && contact.normal_a.x == again.normal_a.x,
        "the contact of a pair", 0);
}

/** Work for a period is worked out on the target, from the images at hand. */
static void check_bound(const image* one, const image* other) {
  flashbvh_tree_size a;
  flashbvh_tree_size b;
  uint32_t work;
  check(flashbvh_image_tree_size(one->bytes, one->size, &a) == FLASHBVH_STATUS_DONE, "size", 0);
  check(flashbvh_image_tree_size(other->bytes, other->size, &b) == FLASHBVH_STATUS_DONE, "size", 1);
  check(flashbvh_most_work(&a, &b) > flashbvh_largest_step(&a, &b), "most work", 0);
  check(flashbvh_work_within(100000, &flashbvh_cortex_m0, &a, &b) <
            flashbvh_work_within(100000, &flashbvh_rv32imac, &a, &b),
        "work on smaller cores", 0);
  work = flashbvh_work_within(100000, &flashbvh_cortex_m4f, &a, &b);
  check(work > 100 && work < 1000, "work within", (long)work);
  check(flashbvh_most_instructions(&flashbvh_cortex_m4f, &a, &b, work) <= 100000, "instructions",
        0);
  check(flashbvh_most_instructions(&flashbvh_cortex_m4f, &a, &b, work + 1) > 100000, "instructions",
        1);
}

int main(void) {
  const image plate = {plate_image, sizeof plate_image};
  const image peg = {peg_image, sizeof peg_image};
  flashbvh_pose pose;
  check_sizes();
  check_poses();
  check_contact();
  check_other_ways(&plate, &peg);
  check_bound(&plate, &peg);
  failures += clearance_failures();
  failures += deformable_failures();
  failures += shape_failures();
  failures += within_failures();
  flashbvh_pose_translated(0, 0, 0, &pose);
  for (int i = 0; i < POSES; ++i) {
    compare(plate, peg, &pose, i);
    compare(peg, peg, &pose, i);
    next_pose(i, &pose);
  }
  check(total > 500 && rotated > 30, "too few pairs to tell", 0);
  port_put("pairs: ");
  port_put_number((long)total);
  port_put(", failures: ");
  port_put_number(failures);
  port_put("\n");
  return failures == 0 ? 0 : 1;
}
