// Options of the decision on pairs of links.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "text/deadline.hpp"

namespace flashbvh::tool {

/// A bound on a placed vertex's error, in cells: 0.51 along each axis for rounding, and the rest
/// for kinematics in double (kinematics.hpp).
constexpr double kPlacing = 0.89;

/// kPlacing for a mesh whose origin's coordinates add up to `far` cells: each axis is off by 2^-23
/// of it more (BasicPairSpace::far_origin()). kPlacing includes 30,000 cells.
inline double placing_at(double far) {
  return std::max(kPlacing, 1.7321 * (0.51 + far * 0x1p-23));
}

/// Two links with distances of their own, in cells.
struct StopDistance {
  std::size_t a;
  std::size_t b;
  double stop;
  double warn;
};

struct MatrixOptions {
  /// In cells. A proof holds for the lattice meshes at exact poses, and for every query whose poses
  /// have errors of twice kPlacing together. Firmware with a larger error of kinematics adds it.
  double slack = 2 * kPlacing;
  /// In cells: a guard stops links that come as near as this. Not part of the verdict.
  double stop = 0;
  double warn = 0;   ///< in cells: a guard warns as near as this. Not part of the verdict, either
  double early = 0;  ///< in cells: how much earlier a guard of simplified links may stop them
  /// In cells, beyond a stop distance: only there does Guard::limit() hold a pair to it.
  double tenth(double distance) const { return limits ? std::max(distance / 10, 10.0) : 0; }
  bool limits = false;
  std::vector<StopDistance> stops;  ///< for pairs with other distances
  /// In cells: a joint box with this much motion or less is not cut again.
  double resolution = 0.5;
  std::uint64_t most_joint_boxes = 1'000'000;  ///< joint boxes searched for a pair
  /// Configurations at which pairs are tested for being near at all of them.
  std::uint32_t looks = 256;
  /// Pairs not decided by then are `undecided`.
  Deadline deadline;

  bool is_late() const { return deadline.is_past(); }
  /// The distances of two links, from `stops` if it has the pair.
  StopDistance distances_of(std::size_t a, std::size_t b) const;
};

}  // namespace flashbvh::tool
