/* A program in C that opens images, asks queries under rotation in slices of every kind, saves and
 * restores them, and compares all of it with C++. */
#include <string.h>

#include "peg.fbvh.h"
#include "plate.fbvh.h"
#include "queries.h"
#include "reference.h"
#include "text.h"

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

int main(void) {
  const image plate = {plate_image, sizeof plate_image};
  const image peg = {peg_image, sizeof peg_image};
  flashbvh_pose pose;
  check_sizes();
  check_poses();
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
