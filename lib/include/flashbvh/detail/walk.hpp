// The walk over pairs of nodes, one of A and one of B: one loop for every order, and one for what
// lies below a leaf.
//
// An order says which pair comes next. It is a class that lives as long as a run, in registers:
//     Tree                    what it walks: nodes, with levels if it needs them; a mesh is a tree
//     Cursor                  where a walk is between runs; default: at its start
//     kStartsAtRoots          whether roots that are disjoint end it with the first visit
//     kStackless              whether a cursor is no more than a pair of nodes
//     Order(a, b, cursor)     at the cursor's pair
//     node_a(), node_b()      the pair of nodes
//     index_a(), index_b()    their indices
//     descend()               to the first pair below this one; false at a pair of leaves
//     next()                  to the pair after this one and all below it; false if there is none
//     leaf()                  of a walk that goes on: which of the two is a leaf whose walk of the
//                             other's subtree it is in
//     leaf_root(), leaf_node()   below which node that walk is to go on, and at which one
//     store(cursor, ended)    where it is; `ended`: next() said that there is nothing more
//     store_below(cursor, leaf, node)   where it is in that walk
// and, if it is stackless, of cursors that come from outside, their indices in range,
//     nodes(a, b, cursor)     the nodes that it stands for
//     cursor_at(a, b, i, j)   the cursor that stands for them
//     can_visit(a, b, cursor) whether a walk over these meshes can be there
//
// A bound says whether two subtrees may still matter, by their boxes: bound(box_a, box_b). It is
// copied into the run; one that has a state is a handle to it.
//
// Once one node is a leaf, all that is left below the pair is that leaf against a subtree, whatever
// the order. If leaves are taken as shapes (leaf_shape.hpp), that has a loop of its own, in which
// shapes.begin(side, node) takes the leaf and shapes.may_touch(box) tests the other tree's boxes;
// where a walk is in it follows from the pair. An order with a stack leaves it alone meanwhile.
// Without shapes the order goes there as the paper has it.
#ifndef FLASHBVH_DETAIL_WALK_HPP
#define FLASHBVH_DETAIL_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/subtree.hpp"

namespace flashbvh {

/// What a query did: the columns of the paper's tables.
struct Counts {
  uint32_t visits;          ///< pairs of boxes tested ("iterations")
  uint32_t overlaps;        ///< of these, pairs that may matter
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
  at_leaf = 4,       ///< within a run: the cursor's pair, one node a leaf, may matter and was visited
};

/// Which of a query's two trees.
enum class Side : uint8_t { none, a, b };

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

/// What a run of a walk may do and has done. Loops keep it in registers.
struct Progress {
  uint32_t visits_left;
  uint32_t overlaps;
};

/// A run of a walk. Its loop keeps but the address, and that in memory: registers are for the rest.
/// `leaf_pair(i, j, progress)`: of a pair of leaves that may matter, whether to go on after it.
template <class Cursor, class LeafPair>
struct WalkRun {
  Cursor* cursor;
  LeafPair* leaf_pair;
  Progress progress;
  Side leaf = Side::none;  ///< of the pair that it stopped at; none: it is not below a leaf
  uint32_t node = 0;       ///< of the other tree, then
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

/// Visits nodes of a subtree, from `at` on, that may touch the shape that was begun, until the end,
/// the last visit granted, or where `found(node)` says stop; there `at` is then. `after`: its node
/// was visited before.
template <class Subtree, class Shapes, class Found>
FLASHBVH_INLINE inline State visit_subtree(Subtree& at, Shapes& shapes, Progress& progress,
                                           const Found& found, bool after) {
  uint32_t visits_left = progress.visits_left;
  uint32_t overlaps = progress.overlaps;
  State end = State::done;
  for (bool visit = !after;; visit = true) {
    if (visit) {
      if (visits_left == 0) {
        end = State::at_pair;
        break;
      }
      --visits_left;
      if (shapes.may_touch(at.node().box)) {
        ++overlaps;
        if (!at.node().is_leaf()) {
          at.descend();
          continue;
        }
        progress = {visits_left, overlaps};
        if (!found(at.index())) {
          end = State::at_leaf_pair;
          break;
        }
      }
    }
    if (!at.next()) {
      break;
    }
  }
  progress = {visits_left, overlaps};
  return end;
}

/// Below a leaf: that leaf as a shape against the other tree's subtree. `from`: at_leaf; or where a
/// run before this one ended, and then no more than a look if it was not below a leaf. Where it
/// ends with run.leaf none, and not done, pairs of nodes go on from there.
template <class Order, class Shapes, class Run>
FLASHBVH_INLINE inline State walk_below_leaf(Shapes& shapes, Run& run, State from) {
  using Tree = typename Order::Tree;
  const bool entered = from == State::at_leaf;
  bool after = from == State::at_leaf_pair;
  Order at(shapes.a, shapes.b, *run.cursor);
  for (;;) {
    const bool leaf_a = at.node_a().is_leaf();
    if (entered && leaf_a && at.node_b().is_leaf()) {
      ++run.progress.overlaps;
      run.leaf = Side::none;
      if (!(*run.leaf_pair)(at.index_a(), at.index_b(), run.progress)) {
        at.store(*run.cursor, false);
        return State::at_leaf_pair;
      }
    } else {
      const Side side = !entered ? at.leaf() : leaf_a ? Side::a : Side::b;
      run.leaf = side;
      if (side == Side::none) {
        break;
      }
      const Tree& other = side == Side::a ? shapes.b : shapes.a;
      const uint32_t leaf = side == Side::a ? at.index_a() : at.index_b();
      const uint32_t inner = side == Side::a ? at.index_b() : at.index_a();
      shapes.begin(side, leaf);
      if (!entered || shapes.slabs_touch(other.nodes[inner].box)) {
        run.progress.overlaps += entered ? 1 : 0;
        Subtree<typename Tree::Index, Tree::kLayout> below(
            other, entered ? inner : at.leaf_root(),
            entered ? other.first_child(inner) : at.leaf_node());
        const auto found = [side, leaf, &run](uint32_t node) {
          return side == Side::a ? (*run.leaf_pair)(leaf, node, run.progress)
                                 : (*run.leaf_pair)(node, leaf, run.progress);
        };
        const State end = visit_subtree(below, shapes, run.progress, found, after);
        if (end != State::done) {
          at.store_below(*run.cursor, side, below.index());
          return end;
        }
      }
    }
    after = false;
    run.leaf = Side::none;
    if (!at.next()) {
      at.store(*run.cursor, true);
      return State::done;
    }
    if (entered || !Order::kStackless) {  // what comes next is a pair of nodes again
      break;
    }
  }
  at.store(*run.cursor, false);
  return after ? State::at_leaf_pair : State::at_pair;
}

/// Pairs of nodes from the cursor, `from` at_leaf_pair or not, to where `leaf_pair` says stop, the
/// end, or the last visit granted; or to a leaf, if `kShapes`. Where it stands then.
template <class Order, bool kShapes, class Bound, class LeafPair>
FLASHBVH_NOINLINE State walk(const typename Order::Tree& a, const typename Order::Tree& b,
                             const Bound& bound, WalkRun<typename Order::Cursor, LeafPair>& run,
                             State from) {
  auto* kept = &run;
  keep_in_memory(kept);
  Bound may_matter = bound;
  put_in_place(may_matter);
  Order at(a, b, *run.cursor);
  uint32_t visits_left = run.progress.visits_left;
  uint32_t overlaps = run.progress.overlaps;
  State end = State::done;
  for (bool visit = from != State::at_leaf_pair;; visit = true) {
    if (visit) {
      if (visits_left == 0) {
        end = State::at_pair;
        break;
      }
      --visits_left;
      if (__builtin_expect(may_matter(at.node_a().box, at.node_b().box), 1)) {
        if (kShapes && (at.node_a().is_leaf() || at.node_b().is_leaf())) {
          end = State::at_leaf;
          break;
        }
        ++overlaps;
        if (at.descend()) {
          continue;
        }
        keep_in_memory(kept);
        const Progress progress = {visits_left, overlaps};
        if (!(*kept->leaf_pair)(at.index_a(), at.index_b(), progress)) {
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
  kept->progress = {visits_left, overlaps};
  return end;
}

/// The whole walk with leaves as shapes, from loop to loop, so that none of them stands on another
/// one's stack. `pairs(from)`: walk(); `below(from)`: walk_below_leaf().
template <class Order, class Run, class Pairs, class Below>
FLASHBVH_INLINE inline State walk_with_shapes(Run& run, State from, const Pairs& pairs,
                                              const Below& below) {
  if (from != State::fresh || !Order::kStartsAtRoots) {
    from = below(from);
    if (from == State::done || run.leaf != Side::none) {
      return from;
    }
  }
  for (;;) {
    from = pairs(from);
    if (from != State::at_leaf) {
      return from;
    }
    from = below(from);
    if (from != State::at_pair || run.leaf != Side::none) {
      return from;
    }
  }
}

}  // namespace detail
}  // namespace flashbvh

#endif
