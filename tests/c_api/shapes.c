/* Shapes in C: a sphere, a capsule, a plate and boxes beside a block of 100 cells, 10,000 cells off
 * its frame's origin along each axis. */
#include "shapes.h"

#include "block.fbvh.h"
#include "flashbvh/clearance.h"
#include "flashbvh/shape.h"

static long failures;

static void check(bool holds) {
  failures += holds ? 0 : 1;
}

typedef struct shapes {
  flashbvh_point_shape point;
  flashbvh_segment_shape segment;
  flashbvh_triangle_shape triangle;
  flashbvh_box_shape box;
} shapes;

static void make(shapes* s, const flashbvh_mesh* like, const flashbvh_triangle* of) {
  const flashbvh_point* const p = &of->corner[0];
  const flashbvh_point* const q = &of->corner[1];
  check(flashbvh_point_shape_make(&s->point, like, p) == FLASHBVH_STATUS_DONE);
  check(flashbvh_segment_shape_make(&s->segment, like, p, q) == FLASHBVH_STATUS_DONE);
  check(flashbvh_triangle_shape_make(&s->triangle, like, of) == FLASHBVH_STATUS_DONE);
  check(flashbvh_box_shape_make(&s->box, like, p, q) == FLASHBVH_STATUS_DONE);
}

/** Whether any points of the two are within so many 1/256 cells, and none within one less. */
static bool are_apart(const flashbvh_mesh* block, const flashbvh_mesh* shape, uint32_t distance) {
  flashbvh_pose pose;
  bool within = false;
  bool nearer = true;
  (void)flashbvh_pose_translated(0, 0, 0, &pose);
  return flashbvh_closer_than(block, shape, &pose, distance, &within) == FLASHBVH_STATUS_DONE &&
         flashbvh_closer_than(block, shape, &pose, distance - 1, &nearer) == FLASHBVH_STATUS_DONE &&
         within && !nearer;
}

/** A sphere above a face; a capsule and a plate across an edge, (30, 40) cells off, so 50. */
static void check_rounded(const flashbvh_mesh* block) {
  const flashbvh_point above = {10050, 10050, 10130};
  const flashbvh_triangle across = {
      {{10130, 9000, 10140}, {10130, 11000, 10140}, {10130, 9000, 12000}}};
  shapes s;
  make(&s, block, &across);
  check(flashbvh_point_shape_make(&s.point, block, &above) == FLASHBVH_STATUS_DONE);
  check(are_apart(block, &s.point.mesh, 30 * 256));
  check(are_apart(block, &s.segment.mesh, 50 * 256));
  check(are_apart(block, &s.triangle.mesh, 50 * 256));
}

/** A box of 20 cells beside the block, which it touches when it is turned by 36.87 degrees about
 * z: then 4/5 * 10 + 3/5 * 10 = 14 cells of it lie on either side of its middle. */
static void check_boxes(const flashbvh_mesh* block) {
  const int32_t one = FLASHBVH_ROTATION_ONE;
  const int32_t turned[9] = {one / 5 * 4, -(one / 5 * 3), 0, one / 5 * 3, one / 5 * 4, 0, 0, 0,
                             one};
  const int32_t beside[3] = {10114, 10050, 10050};
  const flashbvh_point lower = {-10, -10, -10};
  const flashbvh_point upper = {10, 10, 10};
  flashbvh_box_shape box;
  flashbvh_pose pose;
  bool yes = true;
  check(flashbvh_box_shape_make(&box, block, &lower, &upper) == FLASHBVH_STATUS_DONE);
  check(flashbvh_mesh_is_closed(&box.mesh) && flashbvh_mesh_triangles(&box.mesh) == 12);
  (void)flashbvh_pose_translated(beside[0], beside[1], beside[2], &pose);
  check(flashbvh_intersects(block, &box.mesh, &pose, &yes) == FLASHBVH_STATUS_DONE && !yes);
  check(flashbvh_pose_rigid(turned, beside, NULL, &pose) == FLASHBVH_STATUS_DONE);
  check(flashbvh_intersects(block, &box.mesh, &pose, &yes) == FLASHBVH_STATUS_DONE && yes);
}

/** It has no cell, so nothing is told of it, until it is made again. */
static void check_too_large(const flashbvh_mesh* block) {
  const flashbvh_point near = {10050, 10050, 10200};
  const flashbvh_point far = {10050, 10050, 43000};
  flashbvh_segment_shape segment;
  flashbvh_pose pose;
  bool yes = false;
  (void)flashbvh_pose_translated(0, 0, 0, &pose);
  check(flashbvh_segment_shape_make(&segment, block, &near, &far) ==
        FLASHBVH_STATUS_SHAPE_TOO_LARGE);
  check(flashbvh_intersects(block, &segment.mesh, &pose, &yes) == FLASHBVH_STATUS_CELL_MISMATCH);
  check(yes);
  check(flashbvh_segment_shape_make(&segment, block, &near, &near) == FLASHBVH_STATUS_DONE);
  check(are_apart(block, &segment.mesh, 100 * 256));
}

static shape_answer ask(const flashbvh_mesh* block, const flashbvh_mesh* shape,
                        const flashbvh_pose* pose) {
  flashbvh_clearance known;
  shape_answer to = {0, 0, 0};
  check(flashbvh_distance(block, shape, pose, NULL, &known) == FLASHBVH_STATUS_DONE);
  check(flashbvh_count_pairs(block, shape, pose, &to.pairs) == FLASHBVH_STATUS_DONE);
  to.lower = known.lower;
  to.upper = known.upper;
  return to;
}

/** Shapes of every size, turned about x, from inside the block to far outside. */
static void check_against_cpp(const flashbvh_mesh* block) {
  const image bytes = {block_image, sizeof block_image};
  const int32_t c = FLASHBVH_ROTATION_ONE / 5 * 4;
  const int32_t s = FLASHBVH_ROTATION_ONE / 5 * 3;
  const int32_t rotation[9] = {FLASHBVH_ROTATION_ONE, 0, 0, 0, c, -s, 0, s, c};
  uint32_t pairs = 0;
  for (int32_t i = 0; i < 24; ++i) {
    const int32_t cells[3] = {10050, 10050 + 3 * i, 10050};
    const flashbvh_triangle of = {{{i, -i, 0}, {i + 7 * i, 20, 5 * i}, {40 - i, 2 * i, 60}}};
    const flashbvh_mesh* meshes[SHAPES];
    shape_answer expected[SHAPES];
    shapes made;
    flashbvh_pose pose;
    make(&made, block, &of);
    meshes[0] = &made.point.mesh;
    meshes[1] = &made.segment.mesh;
    meshes[2] = &made.triangle.mesh;
    meshes[3] = &made.box.mesh;
    check(flashbvh_pose_rigid(rotation, cells, NULL, &pose) == FLASHBVH_STATUS_DONE);
    ask_shapes_in_cpp(bytes, &of, rotation, cells, expected);
    for (int shape = 0; shape < SHAPES; ++shape) {
      const shape_answer got = ask(block, meshes[shape], &pose);
      check(got.lower == expected[shape].lower && got.upper == expected[shape].upper &&
            got.pairs == expected[shape].pairs);
      pairs += got.pairs;
    }
  }
  check(pairs > 24);
}

static void check_sizes(void) {
  const size_t wider = sizeof(flashbvh_mesh) - 64;
  check(sizeof(flashbvh_point_shape) == 104 + wider);
  check(sizeof(flashbvh_segment_shape) == 112 + wider);
  check(sizeof(flashbvh_triangle_shape) == 120 + wider);
  check(sizeof(flashbvh_box_shape) == 232 + wider);
}

long shape_failures(void) {
  flashbvh_mesh block;
  check(flashbvh_open(block_image, sizeof block_image, &block) == FLASHBVH_STATUS_DONE);
  check_sizes();
  check_rounded(&block);
  check_boxes(&block);
  check_too_large(&block);
  check_against_cpp(&block);
  return failures;
}
