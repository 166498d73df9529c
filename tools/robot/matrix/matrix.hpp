// The collision matrix, decided and not sampled: of every pair of links, whether they can collide
// within the joints' limits. Of neighbours with a joint zone, whether what lies outside it can.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

enum class MatrixVerdict : std::uint8_t {
  never,      ///< proven for all values of the variables within closed limits
  can,        ///< with a witness
  undecided,  ///< closer than can be resolved, too many cells, or no time left
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
  std::optional<std::size_t> zone = {};  ///< of the zones: only what lies outside was decided
  /// What a guard looks at: the two links, or parts of theirs that are not in the zone.
  std::vector<std::pair<std::size_t, std::size_t>> bodies = {{a, b}};
};

/// How far: so many pairs of all are decided. One call at a time, from any thread.
using MatrixProgress = std::function<void(std::size_t decided, std::size_t pairs)>;

/// All pairs of the model's links, also those that the SRDF disables, (0, 1), (0, 2), ... `meshes`:
/// theirs, of the same number, baked with `cell`, in metres; so are `reaches`. `progress` may be
/// empty. On all processors. Deterministic without a deadline; with one, what is hard gets the time
/// that what is easy leaves.
std::vector<PairVerdict> decide_pairs(const Model& model, const std::vector<WholeMesh>& meshes,
                                      const std::vector<JointZone>& zones, const Reaches& reaches,
                                      double cell, const MatrixOptions& options,
                                      const MatrixProgress& progress);

}  // namespace flashbvh::tool
