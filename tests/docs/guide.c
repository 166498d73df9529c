/* The guide's examples in C99. snippets.py writes the included files; only they include headers. */
#include "guide_01.c"
#include "guide_02.c"
#include "guide_04.c"

static verdict verdict_at(float height) {
  const float upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const float base[3] = {0, 0, 0};
  const float at[3] = {0, 0, height};
  flashbvh_pose world;
  check ahead;
  verdict answer = PENDING;
  (void)flashbvh_pose_of_matrix(upright, base, plate_CELLS_PER_UNIT, &world);
  check_start(&ahead, &world, upright, at);
  while (answer == PENDING) {
    answer = check_tick(&ahead);
  }
  return answer;
}

int main(void) {
  return start() && verdict_at(0.5f) == NO_CONTACT && verdict_at(0) == STOP ? 0 : 1;
}
