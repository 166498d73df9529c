/* What both languages tell the same way, and what the arm is told to do. */
#include "robot.h"

uint64_t scratch[SCRATCH_WORDS];

void tell(story* to, uint32_t word) {
  to->hash = (to->hash ^ word) * 16777619u;
  to->hash ^= to->hash >> 15;
  ++to->count;
}

void tell_words(story* to, const void* words, uint32_t count) {
  const uint32_t* const word = words;
  for (uint32_t i = 0; i < count; ++i) {
    tell(to, word[i]);
  }
}

void tell_answer(story* to, flashbvh_guard_answer answer) {
  tell(to, answer.status);
  tell(to, answer.verdict);
  tell(to, answer.pair);
  tell(to, answer.distance);
  tell(to, answer.work);
  ++to->verdicts[answer.verdict];
}

static void tell_point(story* to, const flashbvh_fine_point* p) {
  tell(to, (uint32_t)p->x);
  tell(to, (uint32_t)p->y);
  tell(to, (uint32_t)p->z);
}

void tell_detail(story* to, const flashbvh_pair_detail* detail, const int32_t* changes) {
  tell_point(to, &detail->nearest.point_a);
  tell_point(to, &detail->nearest.point_b);
  tell_words(to, &detail->nearest.direction, 3);
  tell(to, detail->nearest.lower);
  tell(to, detail->nearest.upper);
  tell(to, detail->triangles.a);
  tell(to, detail->triangles.b);
  tell(to, detail->witness.a);
  tell(to, detail->witness.b);
  tell(to, detail->variable);
  tell_words(to, changes, VARIABLES);
}

void tell_motion(story* to, flashbvh_motion_answer answer) {
  tell(to, answer.status);
  tell(to, answer.outcome);
  tell(to, answer.pair);
  if (answer.status == FLASHBVH_STATUS_DONE && answer.outcome == FLASHBVH_MOTION_HIT) {
    tell(to, answer.triangles.a);
    tell(to, answer.triangles.b);
  }
  tell(to, answer.numerator);
  tell(to, answer.level);
  to->outcomes[answer.outcome % 3] += answer.status == FLASHBVH_STATUS_DONE ? 1u : 0u;
}

const float motion_ends[MOTIONS][2][VARIABLES] = {
    {{-1.2f, 0.5f, 1, 0}, {1.2f, 0.3f, 1.3f, 2}},  /* from side to side */
    {{0, 0, 0.5f, 1.5f}, {0, 0.2f, 2.9f, 1.5f}},   /* folded into itself */
    {{-0.6f, 0.5f, 1, 0}, {0.3f, 1.2f, 0.5f, 0}}}; /* into the fence */

void set_point(int motion, int period, float joints[VARIABLES]) {
  const float* const from = motion_ends[motion][0];
  const float* const to = motion_ends[motion][1];
  for (int i = 0; i < VARIABLES; ++i) {
    joints[i] = from[i] + (to[i] - from[i]) * (float)period / PERIODS;
  }
}

/** Half a metre to the left, up by 1 mm each period, turned by a quarter. */
void set_ball(int period, float rotation[9], float metres[3]) {
  for (int i = 0; i < 9; ++i) {
    rotation[i] = i == 1 ? -1 : i == 3 || i == 8 ? 1 : 0;
  }
  metres[0] = 0;
  metres[1] = 0.45f;
  metres[2] = 0.4f + 0.001f * (float)period;
}
