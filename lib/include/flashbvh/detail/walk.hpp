// The walk over pairs of nodes, one of A and one of B: one loop for every order.
//
// An order says which pair comes next. It is a class that lives as long as a run, in registers:
//     Tree                    what it walks: nodes, with levels if it needs them; a mesh is a tree
//     Cursor                  where a walk is between runs; default: at its start
//     kStartsAtRoots          whether roots that are disjoint end it with the first visit
//     Order(a, b, cursor)     at the cursor's pair
//     node_a(), node_b()      the pair of nodes
//     index_a(), index_b()    their indices
//     descend()               to the first pair below this one; false at a pair of leaves
//     next()                  to the pair after this one and all below it; false if there is none
//     store(cursor, ended)    where it is; `ended`: next() said that there is nothing more
// and, if it is stackless, of cursors that come from outside, their indices in range,
//     nodes(a, b, cursor)     the nodes that it stands for
//     can_visit(a, b, cursor) whether a walk over these meshes can be there
//
// A bound says whether two subtrees may still matter, by their boxes: bound(box_a, box_b). It is
// copied into the run; one that has a state is a handle to it.
#ifndef FLASHBVH_DETAIL_WALK_HPP
#define FLASHBVH_DETAIL_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/inline.hpp"

namespace flashbvh {

/// What a query did: the columns of the paper's tables.
struct Counts {
  uint32_t visits;          ///< pairs of boxes tested ("iterations")
  uint32_t overlaps;        ///< of these, pairs that overlap
  uint32_t leaf_pairs;      ///< of these, pairs of leaves ("leaf overlaps")
  uint32_t triangle_pairs;  ///< pairs of triangles that intersect ("geometry overlaps")
};

namespace detail {

/// Where a walk stands.
enum class State : uint8_t {
  fresh = 0,         ///< no visit was made
  at_pair = 1,       ///< the cursor's pair is to be visited next
  at_leaf_pair = 2,  ///< the cursor is at a pair of leaves that may matter, which was visited
  done = 3,          ///< every pair was visited
};

/// A position in a stackless walk: one node of each tree, and nothing else.
template <class IndexType>
struct PairCursor {
  using Index = IndexType;
  Index a = 0;
  Index b = 0;

  /// Whether a walk over these trees has all the memory that it needs.
  template <class Tree>
  bool fits(const Tree& /*a*/, const Tree& /*b*/) const {
    return true;
  }
};

/// What a run of a walk may do, and where it is. Its loop keeps but the address, and that in
/// memory: registers are for the rest.
template <class Cursor, class LeafPair>
struct WalkRun {
  Cursor* cursor;
  Counts* counts;             ///< visits and overlaps are added to
  uint32_t* visits_left;      ///< still granted
  const LeafPair* leaf_pair;  ///< whether to go on after a pair of leaves, by their indices
};

/// What a walk does at a pair of leaves that may matter: it stops.
struct StopAtLeaves {
  bool operator()(uint32_t /*node_a*/, uint32_t /*node_b*/) const { return false; }
};

/// A bound that has a state, as a walk takes it: by a handle.
template <class StatefulBound>
struct ByReference {
  StatefulBound* bound;
  bool operator()(const PackedBox& a, const PackedBox& b) const { return (*bound)(a, b); }
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

/// A bound of its own has its registers in a walk's loop; a handle is seldom read, and leaves them.
template <class Bound>
inline void put_in_place(Bound& /*bound*/) {}
template <class StatefulBound>
inline void put_in_place(ByReference<StatefulBound>& bound) {
  keep_in_memory(bound);
}

/// From the cursor to the pair of leaves where `leaf_pair` says stop, the end, or the last visit
/// granted: where it stands then. `after`: the cursor's pair was visited before; what comes first
/// is the pair after it.
template <class Order, class Bound, class LeafPair>
FLASHBVH_NOINLINE State walk(const typename Order::Tree& a, const typename Order::Tree& b,
                             const Bound& bound,
                             const WalkRun<typename Order::Cursor, LeafPair>& run, bool after) {
  const auto* kept = &run;
  keep_in_memory(kept);
  Bound may_matter = bound;
  put_in_place(may_matter);
  Order at(a, b, *run.cursor);
  uint32_t visits_left = *run.visits_left;
  uint32_t overlaps = run.counts->overlaps;
  State end = State::done;
  for (bool visit = !after;; visit = true) {
    if (visit) {
      if (visits_left == 0) {
        end = State::at_pair;
        break;
      }
      --visits_left;
      if (__builtin_expect(may_matter(at.node_a().box, at.node_b().box), 1)) {
        ++overlaps;
        if (at.descend()) {
          continue;
        }
        keep_in_memory(kept);
        if (!(*kept->leaf_pair)(at.index_a(), at.index_b())) {
          end = State::at_leaf_pair;
          break;
        }
      }
    }
    if (!at.next()) {
      break;
    }
  }
  keep_in_memory(kept);
  at.store(*kept->cursor, end == State::done);
  kept->counts->visits += *kept->visits_left - visits_left;
  kept->counts->overlaps = overlaps;
  *kept->visits_left = visits_left;
  return end;
}

}  // namespace detail
}  // namespace flashbvh

#endif
