// How pairs of links are decided.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/matrix/deadline.hpp"

namespace flashbvh::tool {

/// How far a placed vertex lies from where it should, in cells: 0.51 along each axis of rounding,
/// and what is left for kinematics in double (kinematics.hpp).
constexpr double kPlacing = 0.89;

/// Two links with distances of their own, in cells.
struct StopDistance {
  std::size_t a;
  std::size_t b;
  double stop;
  double warn;
};

struct MatrixOptions {
  /// In cells. A proof holds for the lattice meshes wherever they are exactly, and for every query
  /// of poses that are rounded or worked out to as much: twice kPlacing. Firmware whose kinematics
  /// err by more adds that.
  double slack = 2 * kPlacing;
  /// In cells: how near links may come before a guard stops them. No part of the verdict.
  double stop = 0;
  double warn = 0;                  ///< nor is this: from where it warns of them
  double early = 0;                 ///< so much earlier a guard of simplified links may stop them
  std::vector<StopDistance> stops;  ///< of pairs for which that does not hold
  /// In cells: where so little motion is left in a cell of the joints' values, it is not cut again.
  double resolution = 0.5;
  std::uint64_t most_cells = 1'000'000;  ///< of a pair
  /// Pairs are looked at in so many configurations to see whether they are near in all.
  std::uint32_t looks = 256;
  /// What is not decided by then is `undecided`.
  Deadline deadline;

  bool is_late() const { return deadline.is_past(); }
  /// Of two links, `stops` heeded.
  StopDistance distances_of(std::size_t a, std::size_t b) const;
  bool has_own_distances(std::size_t a, std::size_t b) const;
};

}  // namespace flashbvh::tool
