/* A walk through all topics in C99, with known answers: a blade of a triangle, upright, above and
 * in a block of 10 mm, both drawn a metre off; a cell is 0.1 mm. Queries in slices, contacts and
 * guards in C: the guide's programs and firmware_examples/c_query. */
#include <string.h>

#include "blade.fbvh.h"
#include "block.fbvh.h"
#include "flashbvh/flashbvh.h"
#include "text.h"
#ifdef STORY_HAS_ROBOT
#include "c_arm.robot.h"
#include "flashbvh/robot.h"
#endif

#define CHECK(holds) check((holds), #holds, __LINE__)
#define CHECK_IS(call, status) CHECK((call) == FLASHBVH_STATUS_##status)
/** A call that returns yes or no. */
#define CHECK_YES(call, wanted) CHECK((call) == FLASHBVH_STATUS_DONE && yes == (wanted))

static long failures;
static bool yes;
static flashbvh_mesh block;
static flashbvh_mesh blade;

static void check(bool holds, const char* what, long line) {
  if (!holds) {
    ++failures;
    port_put(what);
    port_put(", line ");
    port_put_number(line);
    port_put("\n");
  }
}

static flashbvh_fine_length fine(uint32_t count) {
  const flashbvh_fine_length length = {count};
  return length;
}

static bool near(float length, float wanted) {
  return length - wanted <= 0.1f / 256 && wanted - length <= 0.1f / 256;
}

static flashbvh_pose translated(int32_t x, int32_t y, int32_t z) {
  const int32_t upright[9] = {FLASHBVH_ROTATION_ONE, 0, 0, 0, FLASHBVH_ROTATION_ONE, 0, 0, 0,
                              FLASHBVH_ROTATION_ONE};
  const int32_t cells[3] = {x, y, z};
  flashbvh_pose pose;
  (void)flashbvh_pose_rigid(upright, cells, NULL, &pose);
  return pose;
}

static void meshes(void) {
  const size_t wider = sizeof(void*) == 8 ? 24 : 0;
  CHECK_IS(flashbvh_open(block_image, sizeof block_image, &block), DONE);
  CHECK_IS(flashbvh_open(blade_image, sizeof blade_image, &blade), DONE);
  CHECK(flashbvh_mesh_unit(&block) == FLASHBVH_UNIT_MM);
  CHECK(flashbvh_mesh_is_closed(&block) && !flashbvh_mesh_is_closed(&blade));
  CHECK(sizeof(flashbvh_cursor) == 12 && sizeof(flashbvh_pose) == 68);
  CHECK(sizeof(flashbvh_mesh) == 72 + wider && sizeof(flashbvh_query) == 128 + wider);
  CHECK(sizeof(flashbvh_box_shape) == 240 + wider && sizeof(flashbvh_contact) == 104);
}

/** The blade is 2.5 mm above the block. */
static void distances(const flashbvh_pose* pose) {
  const float scale = flashbvh_mesh_cells_per_unit(&block);
  flashbvh_clearance found;
  CHECK_IS(flashbvh_distance(&block, &blade, pose, NULL, &found), DONE);
  CHECK(found.in_range && found.lower == 25 * 256 && found.upper == 25 * 256);
  CHECK(near(flashbvh_length_in_unit(found.lower, &block), 2.5f));
  CHECK(found.point_a.z == 10100 * 256 && found.point_b.z == 10125 * 256);
  CHECK(found.direction.x == 0 && found.direction.z == FLASHBVH_ROTATION_ONE);
  CHECK_YES(flashbvh_closer_than(&block, &blade, pose, flashbvh_fine_length_rounded_up(2.5f, scale),
                                 &yes),
            true);
  CHECK_YES(flashbvh_closer_than(&block, &blade, pose, fine(25 * 256 - 1), &yes), false);
}

/** The blade moves down by 7.5 mm; its lower corner meets the block's upper face after 2.5 mm. */
static void motions(const flashbvh_pose* from, const flashbvh_pose* to) {
  const uint32_t cell = FLASHBVH_MOTION_END / 75 + 1;
  flashbvh_body_motion down;
  flashbvh_first_contact_query query;
  flashbvh_first_contact_answer found;
  flashbvh_pair pairs[9];
  CHECK(flashbvh_find_pairs(&block, &blade, to, pairs, 9).count != 0);
  CHECK_IS(flashbvh_body_motion_between(from, to, &down), DONE);
  CHECK_IS(flashbvh_first_contact_start(&query, &block, &blade, &down, fine(0)), SUSPENDED);
  found = flashbvh_first_contact_run(&query, UINT32_MAX);
  CHECK(found.status == FLASHBVH_STATUS_DONE && found.outcome == FLASHBVH_OUTCOME_CONTACT);
  CHECK(found.from <= FLASHBVH_MOTION_END / 3 && found.to >= FLASHBVH_MOTION_END / 3);
  CHECK(found.to - found.from <= cell && found.triangles.b == 0);
}

/** A ray goes down through the block, from 5 mm above it. */
static void rays(void) {
  const float origin[3] = {1003, 1002, 1015};
  const float down[3] = {0, 0, -3};
  flashbvh_segment ray;
  flashbvh_hit hit;
  CHECK_IS(flashbvh_segment_of(origin, down, 30, 10, &ray), DONE);
  CHECK(ray.from.x == 10030 && ray.from.z == 10150 && ray.to.y == 10020 && ray.to.z == 9850);
  CHECK_YES(flashbvh_nearest_hit(&block, &ray, FLASHBVH_NO_HINT, &yes, &hit), true);
  CHECK(hit.side == 1 && flashbvh_distance_along(&ray, &hit) == 50 * 256);
}

/** A box inside the block has no pair with it, but a common point. A capsule is 50 cells away. */
static void solids_and_shapes(void) {
  const flashbvh_point lower = {10040, 10040, 10040};
  const flashbvh_point upper = {10060, 10060, 10060};
  const flashbvh_point ends[2] = {{10130, 9000, 10140}, {10130, 11000, 10140}};
  const flashbvh_pose pose = translated(0, 0, 0);
  flashbvh_box_shape box;
  flashbvh_segment_shape capsule;
  flashbvh_point_side side;
  CHECK_IS(flashbvh_inside(&block, &lower, &side), DONE);
  CHECK(side == FLASHBVH_POINT_INSIDE);
  CHECK_IS(flashbvh_box_shape_make(&box, &block, &lower, &upper), DONE);
  CHECK_YES(flashbvh_intersects(&block, &box.mesh, &pose, &yes), false);
  CHECK_YES(flashbvh_one_is_inside(&block, &box.mesh, &pose, &yes), true);
  CHECK_IS(flashbvh_segment_shape_make(&capsule, &block, &ends[0], &ends[1]), DONE);
  CHECK_YES(flashbvh_closer_than(&block, &capsule.mesh, &pose, fine(50 * 256), &yes), true);
  CHECK_YES(flashbvh_closer_than(&block, &capsule.mesh, &pose, fine(50 * 256 - 1), &yes), false);
}

/** A corner of the block moves through its opposite side. */
static void bending(void) {
  static flashbvh_node nodes[block_NODE_COUNT];
  static flashbvh_vertex vertices[block_VERTEX_COUNT];
  flashbvh_deformable bent;
  uint32_t vertex = 0;
  flashbvh_deformable_make(&bent, &block, nodes, vertices);
  CHECK_YES(flashbvh_intersects_itself(&bent.mesh, &yes), false);
  vertices[0].x = (int16_t)(-3 * vertices[0].x);
  vertices[0].y = (int16_t)(-3 * vertices[0].y / 2);
  CHECK_IS(flashbvh_deformable_refit(&bent, UINT32_MAX, &vertex), DONE);
  CHECK_YES(flashbvh_intersects_itself(&bent.mesh, &yes), true);
}

#ifdef STORY_HAS_ROBOT
/** An arm moves from rest until it folds into itself. */
static void robots(void) {
  static uint32_t motion_state[c_arm_MOTION_STATE_SIZE / 4];
  const float rest[c_arm_VARIABLE_COUNT] = {0, 0, 0.5f, 1.5f};
  const float folded[c_arm_VARIABLE_COUNT] = {0, 0.2f, 2.9f, 1.5f};
  flashbvh_joint_coordinate from[c_arm_VARIABLE_COUNT];
  flashbvh_joint_coordinate to[c_arm_VARIABLE_COUNT];
  flashbvh_mesh links[c_arm_LINK_COUNT];
  flashbvh_robot robot;
  flashbvh_motion motion;
  flashbvh_motion_answer answer;
  flashbvh_view_robot_unchecked(c_arm_robot_image, links, &robot);
  flashbvh_set_values(&robot, rest, from);
  flashbvh_set_values(&robot, folded, to);
  CHECK_IS(flashbvh_motion_init(&motion, &robot, motion_state, sizeof motion_state), DONE);
  CHECK_IS(flashbvh_motion_start(&motion, from, to), DONE);
  answer = flashbvh_motion_run(&motion, UINT32_MAX);
  CHECK(answer.status == FLASHBVH_STATUS_DONE && answer.outcome != FLASHBVH_MOTION_FREE);
}
#endif

int main(void) {
  /* The blade's lower corner is at (1003.1, 1004, 1005) mm of the block, or 7.5 mm higher. */
  const flashbvh_pose standing = translated(20000, 20000, 20000);
  const flashbvh_pose above = translated(20000, 20000, 20075);
  meshes();
  distances(&above);
  motions(&above, &standing);
  rays();
  solids_and_shapes();
  bending();
#ifdef STORY_HAS_ROBOT
  robots();
#endif
  CHECK(strcmp(flashbvh_status_name(FLASHBVH_STATUS_NOT_CLOSED), "not_closed") == 0);
  port_put("failures: ");
  port_put_number(failures);
  port_put("\n");
  return failures == 0 ? 0 : 1;
}
