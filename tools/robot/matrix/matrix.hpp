// The collision matrix, decided and not sampled: of every pair of links, whether they can collide
// within the joints' limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

enum class MatrixVerdict : std::uint8_t {
  never,      ///< proven for all values of the variables within closed limits
  can,        ///< with a witness
  always,     ///< neighbours that intersect wherever they were tried: not guarded
  undecided,  ///< closer than can be resolved, or too many cells
  fixed,      ///< no joint moves them against each other
  believed,  ///< they can, or may, but an SRDF disables them and the user stands by it: not guarded
};
const char* name_of(MatrixVerdict verdict);

struct PairVerdict {
  std::size_t a;  ///< links
  std::size_t b;
  MatrixVerdict verdict;
  std::string reason;
  std::vector<double> witness;  ///< of `can`: a value a variable, at which the exact query says yes
  std::uint64_t cells;          ///< of the joints' values, that were looked at
  /// Whether it is to be guarded: it can collide, or is not proven to stay farther apart than the
  /// stop distance.
  bool is_guarded = false;
  bool is_stopped = false;  ///< guarded, and at no configuration tried farther apart than that
  bool is_warned =
      false;  ///< not stopped so, but nowhere tried farther apart than the warn distance
};

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
  std::vector<StopDistance> stops;  ///< of pairs for which that does not hold
  /// In cells: where so little motion is left in a cell of the joints' values, it is not cut again.
  double resolution = 0.5;
  std::uint64_t most_cells = 1'000'000;  ///< of a pair
  /// Neighbours that intersect at so many configurations, and at no other, are `always`.
  std::uint32_t looks = 256;
};

/// How far: `pair` of `pairs`, and what part of its configurations is decided, 0 to 1.
using MatrixProgress = std::function<void(std::size_t pair, std::size_t pairs, double part)>;

/// All pairs of the model's links, also those that the SRDF disables, (0, 1), (0, 2), ... `meshes`:
/// theirs, of the same number, baked with `cell`, in metres. `progress` may be empty.
/// Deterministic.
std::vector<PairVerdict> decide_pairs(const Model& model, const std::vector<Mesh>& meshes,
                                      double cell, const MatrixOptions& options,
                                      const MatrixProgress& progress);

}  // namespace flashbvh::tool
