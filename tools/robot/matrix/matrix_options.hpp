// Options of the decision on pairs of links.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "robot/model.hpp"
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

/// Two links to guard.
struct GuardedPair {
  std::size_t a;
  std::size_t b;
  double stop;
  double warn;
};

/// How near a guard stops links and warns of them, in metres or in cells.
struct AllDistances {
  double stop = 0;
  double warn = 0;
  std::vector<GuardedPair> own = {};  ///< pairs with their own distances

  GuardedPair of(std::size_t a, std::size_t b) const {
    const GuardedPair* const pair = find_pair(own, a, b);
    return pair != nullptr ? *pair : GuardedPair{a, b, stop, warn};
  }
};

/// Distances are in cells; they are not part of the verdict.
struct MatrixOptions : AllDistances {
  /// In cells. A proof holds for the lattice meshes at exact poses, and for every query whose poses
  /// have errors of twice kPlacing together. Firmware with a larger error of kinematics adds it.
  double slack = 2 * kPlacing;
  double early = 0;  ///< in cells: how much earlier a guard of simplified links may stop them
  /// In cells, beyond a stop distance: only there does Guard::limit() hold a pair to it.
  double tenth(double distance) const { return limits ? std::max(distance / 10, 10.0) : 0; }
  bool limits = false;
  /// In cells: a joint box with this much motion or less is not cut again.
  double resolution = 0.5;
  std::uint64_t most_joint_boxes = 1'000'000;  ///< joint boxes searched for a pair
  /// Configurations at which pairs are tested for being near at all of them.
  std::uint32_t looks = 256;
  /// Pairs not decided by then are `undecided`.
  Deadline deadline;

  bool is_late() const { return deadline.is_past(); }
};

}  // namespace flashbvh::tool
