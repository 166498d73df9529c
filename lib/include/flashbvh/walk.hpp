// What all traversals share: how a walk ends, what it counts, where it is.
//
// A walk visits pairs of nodes, one of A and one of B. Each traversal is a class template over the
// type of the trees with
//     Cursor                  where the walk is; default: at its start
//     kStartsAtRoots          whether roots that are apart end it with the first visit
//     run(a, b, overlap, cursor, budget, leaf_pair) -> Walk
// and, if it is stackless, for cursors that come from outside, their indices in range,
//     nodes(a, b, cursor)     the nodes that it stands for
//     can_visit(a, b, cursor) whether a walk over these trees can be there
// `run` goes on from `cursor`, spends one of `budget.visits_left` per visit, and calls
// leaf_pair(i, j) for each pair of leaves whose boxes overlap. If leaf_pair returns false the walk
// stops at that pair; with `budget.behind` set the next run goes on behind the cursor's pair
// instead of visiting it again.
#ifndef FLASHBVH_WALK_HPP
#define FLASHBVH_WALK_HPP

#include <stdint.h>

/// Walks are not inlined: in a function of its own, a loop gets the registers.
#if defined(__GNUC__)
#define FLASHBVH_NOINLINE [[gnu::noinline]]
#else
#define FLASHBVH_NOINLINE
#endif

namespace flashbvh {

/// How a run of a walk ended.
enum class Walk : uint8_t {
  done,       ///< Every pair was visited.
  suspended,  ///< The budget is spent; the cursor is at the next pair to visit.
  stopped,    ///< leaf_pair said so; the cursor is at that pair, which was visited.
};

/// What a run may do, and what it did.
struct Budget {
  uint32_t visits_left;  ///< visits still granted
  uint32_t overlaps;     ///< incremented by each visit that finds an overlap
  bool behind;           ///< start behind the cursor's pair, which was visited before
};

/// A position in a stackless walk: one node of each tree, and nothing else.
template <class IndexType>
struct PairCursor {
  using Index = IndexType;
  Index a = 0;
  Index b = 0;
};

/// What the loop of a walk seldom needs. Kept in memory, it leaves the registers to the rest.
template <class Cursor, class LeafPair>
struct Outside {
  Cursor* cursor;
  Budget* budget;
  const LeafPair* leaf_pair;
};

/// Tells the compiler that `object` may have changed: it can't live in registers across this call.
template <class Object>
inline void keep_in_memory(Object& object) {
#if defined(__GNUC__)
  __asm__("" : "+m"(object));
#else
  (void)object;
#endif
}

}  // namespace flashbvh

#endif
