// Section 8.3, the post-indexed stackless algorithm: algorithm 4 on trees whose last children lie
// right behind their parents, so that LevelUp(i, x) = i - x (levels.hpp).
//
// Invariant: as stackless.hpp.
#ifndef FLASHBVH_TRAVERSAL_STACKLESS_POST_HPP
#define FLASHBVH_TRAVERSAL_STACKLESS_POST_HPP

#include "flashbvh/traversal/stackless.hpp"

namespace flashbvh {

using StacklessPost = AlternatingStackless<LevelledPostTree>;
using LargeStacklessPost = AlternatingStackless<LargeLevelledPostTree>;

}  // namespace flashbvh

#endif
