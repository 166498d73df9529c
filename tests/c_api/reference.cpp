#include "reference.h"

#include <flashbvh/clearance.hpp>
#include <flashbvh/flashbvh.hpp>
#include <flashbvh/shape.hpp>

#include "shapes.h"
#include "within.h"

using namespace flashbvh;

namespace {

Pose pose_of(const int32_t rotation[9], const int32_t cells[3], const int16_t fraction[3]) {
  int32_t rows[3][3];
  for (int i = 0; i < 9; ++i) {
    rows[i / 3][i % 3] = rotation[i];
  }
  return Pose::rigid(rows, {cells[0], cells[1], cells[2]}, {fraction[0], fraction[1], fraction[2]});
}

shape_answer ask(const PostMesh& mesh, const PostMesh& shape, const Pose& pose) {
  const auto known = distance(mesh, shape, pose);
  return {known.lower, known.upper, count_pairs(mesh, shape, pose).pairs};
}

}  // namespace

void query_in_cpp(image a, image b, const int32_t rotation[9], const int32_t cells[3],
                  const int16_t fraction[3], answer* to) {
  PostMesh tree_a;
  PostMesh tree_b;
  to->count = 0;
  if (open_image(a.bytes, a.size, tree_a) != Status::done ||
      open_image(b.bytes, b.size, tree_b) != Status::done) {
    to->status = FLASHBVH_STATUS_IMAGE_INVALID;
    return;
  }
  const Pose pose = pose_of(rotation, cells, fraction);
  PairQuery query(tree_a, tree_b, pose);
  const Status status = query.run(UINT32_MAX, [to](const PairQuery::Pair& pair) {
    if (to->count < to->room) {
      to->pairs[to->count] = {pair.a, pair.b};
    }
    ++to->count;
    return true;
  });
  const Counts& counts = query.counts();
  to->counts = {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
  to->status = static_cast<flashbvh_status>(status);
}

void band_in_cpp(image a, image b, const flashbvh_pose* pose, uint32_t distance, band* to) {
  int32_t rotation[9];
  int32_t cells[3];
  int16_t fraction[3];
  PostMesh tree_a;
  PostMesh tree_b;
  to->count = 0;
  to->status = FLASHBVH_STATUS_IMAGE_INVALID;
  if (open_image(a.bytes, a.size, tree_a) != Status::done ||
      open_image(b.bytes, b.size, tree_b) != Status::done) {
    return;
  }
  flashbvh_pose_values(pose, rotation, cells, fraction);
  const Pose same = pose_of(rotation, cells, fraction);
  WithinQuery query(tree_a, tree_b, same, {}, within(distance));
  const Status status = query.run(UINT32_MAX, [&](const WithinQuery::Pair& pair) {
    if (to->count < BAND_ROOM) {
      Triangle of_a;
      Triangle of_b;
      query.last_pair(of_a, of_b);
      to->pairs[to->count] = {pair.a, pair.b};
      to->nearest[to->count] = nearest_points_of(of_a, of_b);
    }
    ++to->count;
    return true;
  });
  const Counts& counts = query.counts();
  to->counts = {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
  to->status = static_cast<flashbvh_status>(status);
}

void ask_shapes_in_cpp(image mesh, const flashbvh_triangle* of, const int32_t rotation[9],
                       const int32_t cells[3], shape_answer to[SHAPES]) {
  const int16_t whole[3] = {0, 0, 0};
  const Pose pose = pose_of(rotation, cells, whole);
  const Point p = of->corner[0];
  const Point q = of->corner[1];
  const Point r = of->corner[2];
  PostMesh tree;
  if (open_image(mesh.bytes, mesh.size, tree) != Status::done) {
    return;
  }
  to[0] = ask(tree, PointShape(tree, p).mesh(), pose);
  to[1] = ask(tree, SegmentShape(tree, p, q).mesh(), pose);
  to[2] = ask(tree, TriangleShape(tree, {{p, q, r}}).mesh(), pose);
  to[3] = ask(tree, BoxShape(tree, p, q).mesh(), pose);
}
