#include "near_distances.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::test {
namespace {

constexpr double kFine = 256;
/// Placing rounds a vertex by less than a cell (lib/docs/derivations.md, "Robots").
constexpr double kPlaced = 1;

template <class Visit>
void for_each_corner(const std::array<double, 3>& low, const std::array<double, 3>& high,
                     const Visit& visit) {
  for (unsigned i = 0; i < 8; ++i) {
    visit(std::array<double, 3>{(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
                                (i & 4) != 0 ? high[2] : low[2]});
  }
}

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
  Box3 box;
  box.low.fill(HUGE_VAL);
  box.high.fill(-HUGE_VAL);
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const Vertex& v = mesh.vertices[i];
    const double along[3] = {double(v.x), double(v.y), double(v.z)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], along[axis] + mesh.origin[axis]);
      box.high[axis] = std::max(box.high[axis], along[axis] + mesh.origin[axis]);
    }
  }
  return box;
}

NearOracle::Placement NearOracle::placement_of(const Pose& pose) {
  Placement made;
  for (int i = 0; i < 3; ++i) {
    auto& row = made[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) {
      row[static_cast<std::size_t>(j)] = std::ldexp(pose.rotation(i, j), -30);
    }
    row[3] = pose.translation(i) + std::ldexp(pose.fraction(i), -16);
  }
  return made;
}

/// The largest travel of a point of the box, in cells.
double NearOracle::moved(const Box3& box, const Placement& from, const Placement& to) {
  Placement change;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      change[i][j] = to[i][j] - from[i][j];
    }
  }
  double most = 0;
  for_each_corner(box.low, box.high, [&](const Point3& p) {
    double squared = 0;
    for (const auto& row : change) {
      const double along = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
      squared += along * along;
    }
    most = std::max(most, squared);
  });
  return std::sqrt(most);
}

/// The gap between A's box and the axis-aligned box of B's box in A's frame, in cells.
double NearOracle::gap(const Box3& a, const Box3& b, const Placement& b_in_a) {
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = b_in_a[i][3];
    double high = b_in_a[i][3];
    for (std::size_t j = 0; j < 3; ++j) {
      low += std::min(b_in_a[i][j] * b.low[j], b_in_a[i][j] * b.high[j]);
      high += std::max(b_in_a[i][j] * b.low[j], b_in_a[i][j] * b.high[j]);
    }
    const double apart = std::max({0.0, a.low[i] - high, low - a.high[i]});
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

NearBounds NearOracle::bounds(std::uint32_t pair, const Pose& pose) const {
  const Box3& a = boxes_[robot_.pairs[pair].a];
  const Box3& b = boxes_[robot_.pairs[pair].b];
  const Placement at = placement_of(pose);
  NearBounds found;
  const Measured& last = measured_[pair];
  if (last.is_known) {
    const std::int64_t way = rounded_down(moved(b, last.at, at) + 2 * kPlaced) + 1;
    found.lower = last.lower - way;
    found.upper = last.upper == INT64_MAX ? last.upper : last.upper + way;
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
  last.at = placement_of(pose);
  last.lower = found.lower;
  last.upper = found.upper == UINT32_MAX ? INT64_MAX : std::int64_t{found.upper};
  last.hint = found.in_range ? found.witness : Witness<std::uint16_t>();
  return {found.lower, found.lower};
}

}  // namespace flashbvh::test
