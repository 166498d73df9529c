// The collision matrix: decides without sampling whether two links can collide within the joints'
// limits, for each pair. For neighbours with a joint zone: whether they can collide outside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flashbvh/collide.hpp"
#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

enum class MatrixVerdict : std::uint8_t {
  never,      ///< proven for all values of the variables within closed limits
  can,        ///< proven by a witness
  undecided,  ///< closer than can be resolved, too many joint boxes, or no time left
  fixed,      ///< no joint moves them relative to each other
  believed,   ///< can or undecided; an SRDF disables it and the user vouches for that: not guarded
};
const char* name_of(MatrixVerdict verdict);

struct PairVerdict {
  std::size_t a;  ///< links
  std::size_t b;
  MatrixVerdict verdict;
  std::string reason;
  std::vector<double> witness;  ///< for `can`: values of the variables at which the links intersect
  std::uint64_t joint_boxes;    ///< number of joint boxes searched
  /// True if the pair has to be guarded: it can collide, or is not proven to stay farther apart
  /// than the stop distance.
  bool is_guarded = false;
  /// Without a zone: guarded, and within the stop distance at all configurations tried.
  bool is_stopped = false;
  bool is_warned = false;  ///< not stopped, but at all of them within the warn distance
  std::optional<std::size_t> zone = {};  ///< index of the zone: only its outside was decided
  /// With a zone: for values spread evenly over the joint's range, whether the pair would stop a
  /// guard there.
  std::vector<bool> stops = {};
  /// The bodies that a guard tests: the two links, or their parts outside the zone.
  std::vector<std::pair<std::size_t, std::size_t>> bodies = {{a, b}};

  /// The share of the range of a zone's joint in which the pair alone would stop a guard.
  double share() const;
  /// True if nothing outside the zone is guarded, since the links never collide there.
  bool is_never_outside() const { return zone && verdict == MatrixVerdict::never && !is_guarded; }
};

/// The verdict on a pair for users: `never` only if the two whole links never collide, "never
/// outside zone" if they touch in their joint's zone.
const char* name_of(const PairVerdict& pair);

/// Reports that `decided` of all `pairs` are decided. One call at a time, from any thread.
using MatrixProgress = std::function<void(std::size_t decided, std::size_t pairs)>;

/// Decides all pairs of the model's links, also those that the SRDF disables, in the order (0, 1),
/// (0, 2), ... `meshes`, `reaches`: of each link, made with `cell`, in metres. `progress` may be
/// empty. Uses all processors. Deterministic without a deadline; with one, hard pairs get the time
/// that easy pairs leave.
std::vector<PairVerdict> decide_pairs(const Model& model, const std::vector<WholeMesh>& meshes,
                                      const std::vector<JointZone>& zones, const Reaches& reaches,
                                      double cell, const MatrixOptions& options,
                                      const MatrixProgress& progress);

/// Two triangles of the pair's links that intersect at its witness. `meshes`: of each link.
TrianglePair<WholeMesh::Index> triangles_at(const Model& model,
                                            const std::vector<WholeMesh>& meshes, double cell,
                                            const PairVerdict& pair);

/// For each decided pair with a zone that has to be guarded, the parts of its links outside that
/// may come near; clears its bodies. Where none may, the pair never collides there. The last
/// verdicts.
std::vector<std::vector<ZoneParts>> decide_parts(const Model& model,
                                                 const std::vector<JointZone>& zones, double cell,
                                                 const MatrixOptions& options,
                                                 std::vector<PairVerdict>& pairs);

}  // namespace flashbvh::tool
