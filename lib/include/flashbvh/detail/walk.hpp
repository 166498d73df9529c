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
//     descend()               to the first pair below this one; false if one of them is a leaf
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
// Once one node is a leaf, all that is left below the pair is that leaf against a subtree. The
// leaf is a shape then: shapes.of_a(bound, node) or of_b(bound, node) says what of the other tree
// may touch it (leaf_shape.hpp), and `walk_below` is the loop. Where a walk is in it follows from
// the pair.
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
  Progress progress;
  LeafPair* leaf_pair;
};

/// A leaf's own box as its shape: what bounds alone can tell.
template <class Bound>
struct BoxShapeOfA {
  Bound bound;
  const PackedBox& leaf;
  bool may_touch(const PackedBox& box) const { return bound(leaf, box); }
  static bool slabs_touch(const PackedBox& /*box*/) { return true; }
};
template <class Bound>
struct BoxShapeOfB {
  Bound bound;
  const PackedBox& leaf;
  bool may_touch(const PackedBox& box) const { return bound(box, leaf); }
  static bool slabs_touch(const PackedBox& /*box*/) { return true; }
};
template <class Tree>
struct BoxShapes {
  const Tree& a;
  const Tree& b;

  template <class Bound>
  BoxShapeOfA<Bound> of_a(const Bound& bound, uint32_t node) const {
    return {bound, a.nodes[node].box};
  }
  template <class Bound>
  BoxShapeOfB<Bound> of_b(const Bound& bound, uint32_t node) const {
    return {bound, b.nodes[node].box};
  }
};

/// A bound that has a state, as a walk takes it: by a handle.
template <class StatefulBound>
struct ByReference {
  StatefulBound* bound;
  bool operator()(const PackedBox& a, const PackedBox& b) const { return (*bound)(a, b); }
  auto window_of_a(const PackedBox& a) const { return bound->window_of_a(a); }
  auto window_of_b(const PackedBox& b) const { return bound->window_of_b(b); }
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

/// Visits nodes of a subtree, from `subtree`'s on, that may touch `shape`, until the end, the last
/// visit granted, or where `leaf(node)` says stop. `after`: the node was visited before.
template <class Subtree, class Shape, class Leaf>
FLASHBVH_NOINLINE State walk_below(Subtree& subtree, Shape& shape, Progress& progress,
                                   const Leaf& leaf, bool after) {
  Subtree at = subtree;
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
      if (shape.may_touch(at.node().box)) {
        ++overlaps;
        if (!at.node().is_leaf()) {
          at.descend();
          continue;
        }
        progress = {visits_left, overlaps};
        if (!leaf(at.index())) {
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
  subtree = at;
  return end;
}

/// A leaf against the other tree's subtree below `root`, from `node` on; where it ends is stored,
/// unless it is done.
template <class Order, class Bound, class Shapes, class Run>
FLASHBVH_NOINLINE State walk_leaf(Side side, const Order& at, uint32_t root, uint32_t node,
                                  bool after, const typename Order::Tree& a,
                                  const typename Order::Tree& b, const Bound& bound, Shapes& shapes,
                                  Run& run) {
  using Tree = typename Order::Tree;
  Subtree<typename Tree::Index, Tree::kLayout> subtree(side == Side::a ? b : a, root, node);
  State end;
  if (side == Side::a) {
    auto&& shape = shapes.of_a(bound, at.index_a());
    const auto found = [&](uint32_t j) { return (*run.leaf_pair)(at.index_a(), j, run.progress); };
    end = walk_below(subtree, shape, run.progress, found, after);
  } else {
    auto&& shape = shapes.of_b(bound, at.index_b());
    const auto found = [&](uint32_t i) { return (*run.leaf_pair)(i, at.index_b(), run.progress); };
    end = walk_below(subtree, shape, run.progress, found, after);
  }
  if (end != State::done) {
    at.store_below(*run.cursor, side, subtree.index());
  }
  return end;
}

/// At a pair that may matter, one node or both leaves: to the end of what is below it.
template <class Order, class Bound, class Shapes, class Run>
FLASHBVH_NOINLINE State reach_leaf(const Order& at, const typename Order::Tree& a,
                                   const typename Order::Tree& b, const Bound& bound,
                                   Shapes& shapes, Run& run) {
  const bool leaf_a = at.node_a().is_leaf();
  if (leaf_a && at.node_b().is_leaf()) {
    ++run.progress.overlaps;
    if ((*run.leaf_pair)(at.index_a(), at.index_b(), run.progress)) {
      return State::done;
    }
    auto copy = at;
    copy.store(*run.cursor, false);
    return State::at_leaf_pair;
  }
  const auto below = [&](auto&& shape, const auto& inner, uint32_t node, const auto& tree) {
    if (!shape.slabs_touch(inner.box)) {
      return State::done;
    }
    ++run.progress.overlaps;
    return walk_leaf(leaf_a ? Side::a : Side::b, at, node, tree.first_child(node), false, a, b,
                     bound, shapes, run);
  };
  return leaf_a ? below(shapes.of_a(bound, at.index_a()), at.node_b(), at.index_b(), b)
                : below(shapes.of_b(bound, at.index_b()), at.node_a(), at.index_a(), a);
}

/// From the cursor to where `leaf_pair` says stop, the end, or the last visit granted: where it
/// stands then. `after`: the cursor's pair was visited before; what comes first is the pair after
/// it.
template <class Order, class Bound, class Shapes, class LeafPair>
FLASHBVH_NOINLINE State walk(const typename Order::Tree& a, const typename Order::Tree& b,
                             const Bound& bound, Shapes& shapes,
                             WalkRun<typename Order::Cursor, LeafPair>& run, bool after) {
  Order at(a, b, *run.cursor);
  for (Side leaf = at.leaf(); leaf != Side::none; leaf = at.leaf()) {
    const State end = walk_leaf(leaf, at, at.leaf_root(), at.leaf_node(), after, a, b, bound,
                                shapes, run);
    if (end != State::done) {
      return end;
    }
    after = false;
    if (!at.next()) {
      at.store(*run.cursor, true);
      return State::done;
    }
  }
  auto* kept = &run;
  keep_in_memory(kept);
  Bound may_matter = bound;
  put_in_place(may_matter);
  uint32_t visits_left = run.progress.visits_left;
  uint32_t overlaps = run.progress.overlaps;
  State end = State::done;
  for (bool visit = !after;; visit = true) {
    if (visit) {
      if (visits_left == 0) {
        end = State::at_pair;
        break;
      }
      --visits_left;
      if (__builtin_expect(may_matter(at.node_a().box, at.node_b().box), 1)) {
        if (at.descend()) {
          ++overlaps;
          continue;
        }
        keep_in_memory(kept);
        kept->progress = {visits_left, overlaps};
        const State below = reach_leaf(at, a, b, may_matter, shapes, *kept);
        visits_left = kept->progress.visits_left;
        overlaps = kept->progress.overlaps;
        if (below != State::done) {
          return below;
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

}  // namespace detail
}  // namespace flashbvh

#endif
