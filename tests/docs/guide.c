/* The guide's examples in C99. snippets.py writes the included files; only they include headers. */
#include "guide_01.c"
#include "guide_02.c"
#include "guide_04.c"
#include "guide_05.c"
#include "guide_07.c"

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
