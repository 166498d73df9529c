// Pairs of links that move relative to each other and that no guard tests, or only outside a zone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "robot/matrix/matrix.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// A collision of the two links, or in their zone, is never detected.
struct UnguardedPair {
  std::size_t a;  ///< links, a below b
  std::size_t b;
  WhyUnguarded why;
  std::size_t joint = kNoJoint;  ///< of a zone
  double radius = 0;             ///< of a zone, in metres
  /// Of a zone: nothing outside is guarded, since the links never collide there.
  bool is_never_outside = false;
};

/// For users: "touch within 0.126 m about elbow", and ", never outside zone" if so.
std::string reason_of(const Model& model, const UnguardedPair& pair);

/// The pairs that may collide and that are not guarded, or only outside a zone; in their order.
std::vector<UnguardedPair> unguarded_pairs(const std::vector<PairVerdict>& pairs,
                                           const std::vector<JointZone>& zones);

/// Conversions to firmware's form and back.
RobotUnguarded fixed_unguarded(const UnguardedPair& pair, double cell);
UnguardedPair unguarded_pair(const RobotUnguarded& fixed, double cell, bool is_never_outside);

/// "base - arm within 0.1 m about shoulder, arm - hand": the pairs by the names of their links. A
/// zone is followed by "(never outside zone)" if that is proven.
std::string names_of(const Model& model, const std::vector<UnguardedPair>& pairs);

/// Warns of each reason with all its pairs by name, its meaning and a remedy.
void warn_of_unguarded(const Model& model, const std::vector<UnguardedPair>& pairs,
                       const std::string& path, Warnings& warnings);

/// "elbow 1.2, wrist 0": the values at a pair's witness, of the joints between its links.
std::string witness_text(const Model& model, const PairVerdict& pair);

/// Marks the disabled pair of links `a` and `b` as believed. UserError, at `place`, if the SRDF
/// does not disable it.
void believe(std::size_t a, std::size_t b, const std::string& place, Model& model);

/// UserError, with the line of `srdf`, the joints' values and the fix, if a disabled pair can
/// collide and is not believed; names all such pairs. Warns of undecided pairs, and of pairs that
/// are believed needlessly.
void check_disabled(const Model& model, const std::vector<PairVerdict>& pairs,
                    const std::string& srdf, Warnings& warnings);

}  // namespace flashbvh::tool
