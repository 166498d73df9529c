// The stage that divides neighbours: of links that touch about their joint, a guard tests the parts
// outside its zone that may come near.
#pragma once

#include <vector>

#include "robot/matrix/unguarded.hpp"
#include "robot/pipeline/decide.hpp"

namespace flashbvh::tool {

/// A robot and all that its guard tests: the links, and parts of links as further links.
struct Divided : Prepared, Decided {
  std::vector<UnguardedPair> unguarded;  ///< the pairs that no guard tests
};

/// Adds the parts to the links, their trees, sizes and reaches, and to the pairs' bodies. UserError
/// if firmware can't hold so many.
Divided divide(Prepared robot, Decided decided, const RobotRequest& request);

/// Warns of pairs that no guard tests, of pairs with their own distances that no joint moves, and
/// of pairs for which a guard would report one verdict in all configurations.
void warn_of_guard(const Divided& robot, const RobotRequest& request, Warnings& warnings);

}  // namespace flashbvh::tool
