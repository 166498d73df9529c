/* A machine whose tool tilts above a plate, in C99. Before each move the control loop tests whether
 * the tool would hit the plate at its target. Each tick computes one slice of the answer, so ticks
 * stay short for any meshes. */
#include <flashbvh/flashbvh.h>

#include "peg.fbvh.h"
#include "plate.fbvh.h"
#include "text.h"

/* A slice's share of a tick on a Cortex-M4F: a proven limit, for any pose. */
enum { INSTRUCTIONS_PER_TICK = 12000 };
static const flashbvh_tree_size plate_size = plate_TREE_SIZE;
static const flashbvh_tree_size tool_size = peg_TREE_SIZE;

/** A target position of the tool. */
typedef struct target {
  const char* name;
  float height; /**< of the tool's tip above the plate, mm */
  bool tilted;  /**< by 36.87 degrees: sine 3/5, cosine 4/5 */
} target;

static const target targets[] = {
    {"4 mm up, upright", 4, false}, {"4 mm up, tilted", 4, true}, {"2 mm up, tilted", 2, true}};
/* As a faulty sensor may report at reset: the tool, 30 mm long, inside the plate, 40 mm thick. */
static const target wholly_inside = {"35 mm down", -35, false};

/** A check in progress. */
typedef struct check {
  flashbvh_pose pose;
  flashbvh_query query; /* points at the pose: a check must not be moved in memory */
  flashbvh_status status;
} check;

typedef enum verdict { VERDICT_PENDING, VERDICT_FREE, VERDICT_COLLIDES } verdict;

static flashbvh_mesh plate;
static flashbvh_mesh tool;
static uint32_t work_per_tick;

static void check_start(check* c, const target* to) {
  const float sine = to->tilted ? 0.6f : 0;
  const float cosine = to->tilted ? 0.8f : 1;
  const float about_y[9] = {cosine, 0, sine, 0, 1, 0, -sine, 0, cosine};
  const float translation[3] = {0, 0, to->height};
  /* Errors of both calls appear in the status of each run, too. */
  flashbvh_pose_of_matrix(about_y, translation, flashbvh_mesh_cells_per_unit(&plate), &c->pose);
  c->status = flashbvh_query_start(&c->query, &plate, &tool, &c->pose);
}

/** Prints where the pair that ended the last run touches, in the plate's frame. */
static void print_contact(const check* c) {
  flashbvh_contact contact;
  flashbvh_query_last_contact(&c->query, &contact);
  port_put("first contact at height ");
  port_put_number((long)(1000 * flashbvh_length_in_unit(contact.ends[0].z, &plate)));
  port_put(" um\n");
}

/** Runs a slice of as much work as fits the tick. The tick after the last slice tests whether one
 * body is wholly inside the other. */
static verdict check_tick(check* c) {
  flashbvh_pair found[1];
  bool inside = true;
  if (c->status == FLASHBVH_STATUS_DONE) { /* no triangles intersect */
    c->status = flashbvh_one_is_inside(&plate, &tool, &c->pose, &inside);
    return c->status == FLASHBVH_STATUS_DONE && !inside ? VERDICT_FREE : VERDICT_COLLIDES;
  }
  c->status = flashbvh_query_run(&c->query, work_per_tick, found, 1).status;
  /* FULL means that a pair was found. All others are errors, which are no permission to move on. */
  return c->status == FLASHBVH_STATUS_SUSPENDED || c->status == FLASHBVH_STATUS_DONE
             ? VERDICT_PENDING
             : VERDICT_COLLIDES;
}

/** The control loop: runs until the tool is at the target or must not go there. */
static verdict control_loop(const target* to) {
  check ahead;
  verdict answer = VERDICT_PENDING;
  long ticks = 0;
  check_start(&ahead, to);
  while (answer == VERDICT_PENDING) {
    answer = check_tick(&ahead);
    ++ticks;
    /* A real machine reads its sensors and drives its motors here, then waits for the next tick. */
  }
  port_put(to->name);
  port_put(answer == VERDICT_FREE ? ": free after " : ": collides after ");
  port_put_number(ticks);
  port_put(" ticks\n");
  if (ahead.status == FLASHBVH_STATUS_FULL) {
    print_contact(&ahead);
  }
  return answer;
}

int main(void) {
  const size_t count = sizeof targets / sizeof targets[0];
  float height = -1;
  flashbvh_view_unchecked(plate_image, &plate);
  flashbvh_view_unchecked(peg_image, &tool);
  work_per_tick =
      flashbvh_work_within(INSTRUCTIONS_PER_TICK, &flashbvh_cortex_m4f, &plate_size, &tool_size);
  if (work_per_tick == 0) {
    port_put("a tick has no time for a slice\n");
    return 1;
  }
  for (size_t i = 0; i < count && control_loop(&targets[i]) == VERDICT_FREE; ++i) {
    height = targets[i].height;
  }
  port_put("stopped at ");
  port_put_number((long)height);
  port_put(" mm\n");
  return (long)height == 4 && control_loop(&wholly_inside) == VERDICT_COLLIDES ? 0 : 1;
}
