#include "pose_search.hpp"

#include <algorithm>

#include "flashbvh/collide.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/pose.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

constexpr std::int32_t kRadius = 20000;
constexpr std::int64_t kScanSteps = 64;

/// Rounded down.
std::int64_t length_of(const std::int64_t (&v)[3]) {
  return square_root(static_cast<std::uint64_t>(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
}

/// A uniform point in a ball, but not near its middle: so its direction is uniform, too.
template <std::size_t dimensions>
void set_in_ball(test::Random& random, std::int64_t (&point)[dimensions]) {
  constexpr std::int64_t most = std::int64_t{kRadius} * kRadius;
  std::int64_t square = 0;
  do {
    square = 0;
    for (std::int64_t& part : point) {
      part = random.between(-kRadius, kRadius);
      square += part * part;
    }
  } while (square > most || square < most / 16);
}

/// The middle of the root's box in the mesh's frame, in half cells, and its sides.
void measure_root(const Mesh& tree, std::int64_t (&middle)[3], std::int64_t (&side)[3]) {
  const Box box = unpack(tree.nodes[0].box);
  const std::int64_t lower[3] = {box.lower.x, box.lower.y, box.lower.z};
  const std::int64_t upper[3] = {box.upper.x, box.upper.y, box.upper.z};
  for (int axis = 0; axis < 3; ++axis) {
    middle[axis] = 2 * std::int64_t{tree.origin[axis]} + lower[axis] + upper[axis];
    side[axis] = upper[axis] - lower[axis];
  }
}

}  // namespace

PoseSearch::PoseSearch(const Meshes& searched, const Meshes& queried, std::uint64_t seed)
    : searched_(searched), queried_(queried), random_(seed) {
  std::int64_t side_a[3];
  std::int64_t side_b[3];
  measure_root(*searched.a, middle_a_, side_a);
  measure_root(*searched.b, middle_b_, side_b);
  reach_ = (length_of(side_a) + length_of(side_b)) / 2 + 3;
  size_b_ = *std::max_element(side_b, side_b + 3);
}

QueryPose PoseSearch::next(Proximity proximity, bool rotated) {
  for (;;) {
    const Approach approach = any_approach(rotated);
    const std::int64_t touching = touching_distance(approach);
    QueryPose query_pose = at(approach, touching + gap_of(proximity));
    if (touching >= 0 && is(proximity, query_pose)) {
      return query_pose;
    }
  }
}

PoseSearch::Approach PoseSearch::any_approach(bool rotated) {
  Approach approach{};
  std::int64_t q[4] = {1, 0, 0, 0};
  if (rotated) {
    set_in_ball(random_, q);
  }
  std::copy(q, q + 4, approach.rotated.quaternion);
  set_in_ball(random_, approach.direction);
  return approach;
}

QueryPose PoseSearch::at(const Approach& approach, std::int64_t distance) const {
  QueryPose query_pose = approach.rotated;
  const Pose rotated = pose_of(query_pose);
  for (int axis = 0; axis < 3; ++axis) {
    std::int64_t middle = 0;  // B's middle, rotated
    for (int i = 0; i < 3; ++i) {
      middle += rotated.rotation(axis, i) * middle_b_[i];
    }
    query_pose.cells[axis] = static_cast<std::int32_t>(
        (middle_a_[axis] - middle / kRotationOne) / 2 +
        approach.direction[axis] * distance / length_of(approach.direction));
  }
  return query_pose;
}

bool PoseSearch::touches(const Approach& approach, std::int64_t distance) const {
  const Pose pose = pose_of(at(approach, distance));
  return intersects(*searched_.a, *searched_.b, pose).yes;
}

std::int64_t PoseSearch::touching_distance(const Approach& approach) const {
  std::int64_t step = kScanSteps;
  while (step >= 0 && !touches(approach, reach_ * step / kScanSteps)) {
    --step;
  }
  if (step < 0) {
    return -1;
  }
  std::int64_t touching = reach_ * step / kScanSteps;
  std::int64_t disjoint = reach_ * (step + 1) / kScanSteps;
  while (disjoint - touching > 1) {
    const std::int64_t between = (touching + disjoint) / 2;
    (touches(approach, between) ? touching : disjoint) = between;
  }
  return touching;
}

std::int64_t PoseSearch::gap_of(Proximity proximity) {
  switch (proximity) {
    case Proximity::separated:
      return random_.between(0, static_cast<std::int32_t>(reach_));
    case Proximity::small:
      return size_b_ * random_.between(3, 40) / 100;
    case Proximity::close:
      return size_b_ / 100;
    case Proximity::intersecting:
      break;
  }
  return -size_b_ * random_.between(1, 50) / 100;
}

bool PoseSearch::is(Proximity proximity, QueryPose& query_pose) const {
  const Pose pose = pose_of(query_pose);
  constexpr auto every_pair = [](const PairQuery::Pair&) { return true; };
  // Classes depend on boxes alone, so that other rejections do not change the poses.
  Query<Ranked<Mesh>, detail::BoxIntersection> by_boxes(*searched_.a, *searched_.b, pose);
  PairQuery query(*queried_.a, *queried_.b, pose);
  constexpr std::uint32_t kGranted = UINT32_MAX - 1;  // which counts as a limit
  const RunResult step = query.run(kGranted, every_pair);
  if (by_boxes.run(UINT32_MAX, every_pair).status != Status::done || step.status != Status::done) {
    return false;
  }
  query_pose.work = step.work;
  query_pose.visits = query.stats().visits;
  query_pose.leaf_pairs = query.stats().leaf_pairs;
  query_pose.triangle_pairs = query.stats().triangle_pairs;
  const QueryStats& counts = by_boxes.stats();
  if (counts.triangle_pairs != 0) {
    return proximity == Proximity::intersecting;
  }
  const Proximity found = counts.visits == 1                   ? Proximity::separated
                          : counts.leaf_pairs <= kFewLeafPairs ? Proximity::small
                                                               : Proximity::close;
  return proximity == found;
}

}  // namespace figures
