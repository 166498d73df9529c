/* A machine whose tool tilts above a plate, in C99. Before each move the control loop asks whether
 * the tool would hit the plate where it is about to go: a slice of the answer in each tick, so that
 * the tick stays short, whatever the meshes. */
#include <flashbvh/flashbvh.h>

#include "peg.fbvh.h"
#include "plate.fbvh.h"
#include "text.h"

enum {
  CELLS_PER_MM = 100, /* the meshes are baked with cells of 0.01 mm */
  WORK_PER_TICK = 40
};

/** A place for the tool to go. */
typedef struct target {
  const char* name;
  int32_t height; /**< of the tool's tip above the plate, mm */
  bool tilted;    /**< by 36.87 degrees: sine 3/5, cosine 4/5 */
} target;

static const target targets[] = {
    {"4 mm up, upright", 4, false}, {"4 mm up, tilted", 4, true}, {"2 mm up, tilted", 2, true}};

/** A question on its way. */
typedef struct check {
  flashbvh_pose pose;
  flashbvh_query query; /* points at the pose: a check stays where it is */
} check;

typedef enum verdict { VERDICT_PENDING, VERDICT_FREE, VERDICT_COLLIDES } verdict;

static flashbvh_mesh plate;
static flashbvh_mesh tool;

static void check_start(check* c, const target* to) {
  const int32_t one = FLASHBVH_ROTATION_ONE;
  const int32_t sine = to->tilted ? one / 5 * 3 : 0;
  const int32_t cosine = to->tilted ? one / 5 * 4 : one;
  const int32_t about_y[9] = {cosine, 0, sine, 0, one, 0, -sine, 0, cosine};
  const int32_t cells[3] = {0, 0, to->height * CELLS_PER_MM};
  /* Errors of both show in every run. */
  flashbvh_pose_rigid(about_y, cells, NULL, &c->pose);
  flashbvh_query_start(&c->query, &plate, &tool, &c->pose);
}

/** A slice of the answer: lib/docs/bounded_time.md tells what so much work takes. */
static verdict check_tick(check* c) {
  flashbvh_pair found[1];
  uint32_t count = 0;
  const flashbvh_status status = flashbvh_query_run(&c->query, WORK_PER_TICK, found, 1, &count);
  if (status == FLASHBVH_STATUS_SUSPENDED) {
    return VERDICT_PENDING; /* not finished: the next tick goes on */
  }
  /* Free: no triangles intersect; a tool wholly inside the plate is not told. An error is no
   * permission to move on. */
  return status == FLASHBVH_STATUS_DONE ? VERDICT_FREE : VERDICT_COLLIDES;
}

/** The control loop, until the tool is at the target or must not go there. */
static verdict control_loop(const target* to) {
  check ahead;
  verdict answer = VERDICT_PENDING;
  long ticks = 0;
  check_start(&ahead, to);
  while (answer == VERDICT_PENDING) {
    answer = check_tick(&ahead);
    ++ticks;
    /* Here a machine reads its sensors and drives its motors, and waits for the next tick. */
  }
  port_put(to->name);
  port_put(answer == VERDICT_FREE ? ": free after " : ": collides after ");
  port_put_number(ticks);
  port_put(" ticks\n");
  return answer;
}

int main(void) {
  const size_t count = sizeof targets / sizeof targets[0];
  long height = -1;
  if (flashbvh_open(plate_image, sizeof plate_image, &plate) != FLASHBVH_STATUS_DONE ||
      flashbvh_open(peg_image, sizeof peg_image, &tool) != FLASHBVH_STATUS_DONE) {
    port_put("the images are damaged\n");
    return 1;
  }
  for (size_t i = 0; i < count && control_loop(&targets[i]) == VERDICT_FREE; ++i) {
    height = targets[i].height;
  }
  port_put("stopped at ");
  port_put_number(height);
  port_put(" mm\n");
  return height == 4 ? 0 : 1;
}
