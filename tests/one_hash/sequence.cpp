#include "sequence.hpp"

#include "cell_arm.robot.h"
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/robot_float.hpp"
#include "gear.fbvh.h"
#include "lump.fbvh.h"
#include "torus.fbvh.h"

namespace one_hash {

using namespace flashbvh;

const Image kImage[kImages] = {{"torus.fbvh", torus_image, torus_IMAGE_BYTES},
                               {"lump.fbvh", lump_image, lump_IMAGE_BYTES},
                               {"gear.fbvh", gear_image, gear_IMAGE_BYTES},
                               {"arm.robot", cell_arm_robot_image, cell_arm_IMAGE_BYTES}};

namespace {

void add_pair(const TrianglePair<uint16_t>& pair, Hash& hash) {
  hash.add(pair.a | static_cast<uint32_t>(pair.b) << 16);
}

void add_point(const FinePoint& point, Hash& hash) {
  hash.add(static_cast<uint32_t>(point.x));
  hash.add(static_cast<uint32_t>(point.y));
  hash.add(static_cast<uint32_t>(point.z));
}

void add_query(Kind kind, const Mesh& a, const Mesh& b, const Pose& pose, Hash& hash) {
  if (kind == Kind::intersects) {
    hash.add(intersects(a, b, pose).yes ? 1 : 0);
  } else if (kind == Kind::distance) {
    const Clearance<uint16_t> found = distance(a, b, pose);
    hash.add(found.lower);
    hash.add(found.upper);
    add_pair(found.triangles, hash);
    add_point(found.point_a, hash);
    add_point(found.point_b, hash);
  } else {
    TrianglePair<uint16_t> pair{};
    const Answer answer = first_pair(a, b, pose, pair);
    hash.add(answer.yes ? 1 : 0);
    add_pair(pair, hash);
  }
}

void add_queries(uint32_t count, uint32_t kinds, Hash& hash) {
  const Mesh meshes[] = {view_unchecked<Mesh>(torus_image), view_unchecked<Mesh>(lump_image),
                         view_unchecked<Mesh>(gear_image)};
  const float cells = cells_per_unit(meshes[0].cell_bits);
  Poses poses;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t block = i / kBlock;
    const uint32_t a = block / kinds % kMeshes;
    const PoseFloats at = poses.next();
    add_query(static_cast<Kind>(block % kinds), meshes[a], meshes[(a + 1) % kMeshes],
              pose_of(at.rotation, at.translation, cells), hash);
  }
}

Mesh links[cell_arm_LINK_COUNT];
GuardStateOf<cell_arm_JOINT_COUNT, cell_arm_PAIR_COUNT, cell_arm_PAIR_JOINT_COUNT> state;

void add_periods(uint32_t count, Hash& hash) {
  static_assert(kVariables == cell_arm_VARIABLE_COUNT, "the arm's");
  const Robot robot = view_robot_unchecked(cell_arm_robot_image, links);
  Guard guard(robot, state);
  Trajectory trajectory;
  for (uint32_t i = 0; i < count; ++i) {
    JointCoordinate values[kVariables];
    set_values(robot, trajectory.next().radians, values);
    const GuardAnswer answer = guard.update(values, i == 0 ? kAllWork : kWork);
    hash.add(static_cast<uint32_t>(answer.verdict));
    hash.add(answer.pair);
    hash.add(answer.distance);
    hash.add(answer.work);
  }
}

}  // namespace

uint32_t hash_of(uint32_t queries, uint32_t periods, uint32_t kinds) {
  Hash hash;
  add_queries(queries, kinds, hash);
  add_periods(periods, hash);
  return hash.value();
}

}  // namespace one_hash
