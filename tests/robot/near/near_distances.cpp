#include "near_distances.hpp"

#include <algorithm>
#include <cmath>

#include "support/oracles/float_distance.hpp"

namespace flashbvh::test {
namespace {

constexpr double kFine = 256;
/// Placing rounds a vertex by less than a cell (lib/docs/derivations.md, "Robots").
constexpr double kPlaced = 1;

std::int64_t rounded_down(double cells) {
  return static_cast<std::int64_t>(std::floor(cells * kFine));
}

}  // namespace

NearOracle::NearOracle(const Robot& robot) : robot_(robot), measured_(robot.pair_count) {
  for (std::uint32_t i = 0; i < robot.link_count; ++i) {
    boxes_.push_back(box_of(robot.meshes[i]));
  }
}

NearOracle::Box3 NearOracle::box_of(const Mesh& mesh) {
  const std::vector<Vector3> vertices = vertices_of(mesh);
  Box3 box = {vertices[0], vertices[0]};
  for (const Vector3& v : vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], v[axis]);
      box.high[axis] = std::max(box.high[axis], v[axis]);
    }
  }
  return box;
}

/// The largest travel of a point of the box, in cells.
double NearOracle::moved(const Box3& box, const Transform& from, const Transform& to) {
  double most = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3 corner = {(i & 1) != 0 ? box.high[0] : box.low[0],
                            (i & 2) != 0 ? box.high[1] : box.low[1],
                            (i & 4) != 0 ? box.high[2] : box.low[2]};
    most = std::max(most, squared(minus(placed(to, corner), placed(from, corner))));
  }
  return std::sqrt(most);
}

/// The gap between A's box and the axis-aligned box of B's box in A's frame, in cells.
double NearOracle::gap(const Box3& a, const Box3& b, const Transform& b_in_a) {
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = b_in_a.translation[i];
    double high = low;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto [least, most] =
          std::minmax({b_in_a.rotation[i][j] * b.low[j], b_in_a.rotation[i][j] * b.high[j]});
      low += least;
      high += most;
    }
    const double apart = std::max({0.0, a.low[i] - high, low - a.high[i]});
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

NearBounds NearOracle::bounds(std::uint32_t pair, const Pose& pose) const {
  const Box3& a = boxes_[robot_.pairs[pair].a];
  const Box3& b = boxes_[robot_.pairs[pair].b];
  const Transform at = transform_of(pose);
  NearBounds found;
  const Measured& last = measured_[pair];
  if (last.is_known) {
    const std::int64_t way = rounded_down(moved(b, last.at, at) + 2 * kPlaced) + 1;
    found.lower = last.lower - way;
    found.upper = last.upper + way;
  }
  found.lower = std::max(found.lower, rounded_down(gap(a, b, at) - kPlaced));
  found.lower = std::clamp<std::int64_t>(found.lower, 0, found.upper);
  return found;
}

NearBounds NearOracle::measured(std::uint32_t pair, const Pose& pose) {
  ++queries_;
  const RobotPair& of = robot_.pairs[pair];
  Measured& last = measured_[pair];
  const Clearance<std::uint16_t> found =
      distance(robot_.meshes[of.a], robot_.meshes[of.b], pose, last.hint);
  last.is_known = true;
  last.at = transform_of(pose);
  last.lower = found.lower;
  last.upper = found.upper == UINT32_MAX ? kUnbounded : std::int64_t{found.upper};
  last.hint = found.in_range ? found.witness : Witness<std::uint16_t>();
  return {found.lower, found.lower};
}

}  // namespace flashbvh::test
