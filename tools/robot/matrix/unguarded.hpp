// Pairs of links that a joint moves and that no guard looks at, or only outside a joint zone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "robot/matrix/matrix.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// A collision of the two, or in the zone, is never detected.
struct UnguardedPair {
  std::size_t a;  ///< links, a below b
  std::size_t b;
  WhyUnguarded why;
  std::size_t joint = kNoJoint;  ///< of a zone
  double radius = 0;             ///< of a zone, in metres
};

/// For people: "touch within 0.126 m about elbow".
std::string reason_of(const Model& model, const UnguardedPair& pair);

/// Of all pairs those that may collide, and that are not guarded all the same; in their order.
std::vector<UnguardedPair> unguarded_pairs(const std::vector<PairVerdict>& pairs,
                                           const std::vector<JointZone>& zones);

/// As firmware holds it, and back.
RobotUnguarded fixed_unguarded(const UnguardedPair& pair, double cell);
UnguardedPair unguarded_pair(const RobotUnguarded& fixed, double cell);

/// "base - arm within 0.1 m about shoulder, arm - hand": the pairs by the names of their links.
std::string names_of(const Model& model, const std::vector<UnguardedPair>& pairs);

/// For users: each reason with all its pairs by name, what it means and what they can do.
std::vector<std::string> unguarded_warnings(const Model& model,
                                            const std::vector<UnguardedPair>& pairs);

/// "elbow 1.2, wrist 0": the values at a pair's witness, of the joints between its links.
std::string witness_text(const Model& model, const PairVerdict& pair);

/// Marks the disabled pair of links `a` and `b` as believed. UserError, at `place`, if the SRDF
/// does not disable it.
void believe(std::size_t a, std::size_t b, const std::string& place, Model& model);

/// UserError, with the line of `srdf`, the joints' values and the fix, if a pair that is disabled
/// can collide and is not believed; names all such pairs. Warns of those that are undecided,
/// and of those that are believed for nothing.
void check_disabled(const Model& model, const std::vector<PairVerdict>& pairs,
                    const std::string& srdf, Warnings& warnings);

}  // namespace flashbvh::tool
