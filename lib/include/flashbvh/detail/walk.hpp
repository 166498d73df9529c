// The walk over pairs of nodes, one of A and one of B: one loop for every order, and one for what
// lies below a leaf.
//
// An order says which pair comes next. It is a class that lives as long as a run, in registers:
//     Tree                    what it walks: nodes, with levels if it needs them; a mesh is a tree
//     Cursor                  where a walk is between runs; default: at its start
//     kStartsAtRoots          whether roots that are disjoint end it with the first visit
//     kStackless              whether a cursor is no more than a pair of nodes
//     kBelowLeaves            whether leaf() is never none
//     Order(a, b, cursor)     at the cursor's pair
//     node_a(), node_b()      the pair of nodes
//     index_a(), index_b()    their indices
//     descend()               to the first pair below this one; false at a pair of leaves
//     descend_inner()         the same of a pair of which none is a leaf, unless kBelowLeaves
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
// shapes.begin(side, node, box) takes the leaf, after shapes.take_again(side, node) if a run goes
// on below it; it is shapes.work_of(side, node). And shapes.may_touch(box) tests the other tree's
// boxes; where a walk is in it follows from the pair. An order with a stack leaves it alone
// meanwhile. Without shapes the order goes there as the paper has it. Shapes that have kKnowsRoot
// keep below which node a walk stopped, for the next one of the same run.
#ifndef FLASHBVH_DETAIL_WALK_HPP
#define FLASHBVH_DETAIL_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/subtree.hpp"
#include "flashbvh/detail/work.hpp"

namespace flashbvh {

/// What a query did: the columns of the paper's tables.
struct Counts {
  uint32_t visits;          ///< pairs of boxes tested ("iterations")
  uint32_t overlaps;        ///< of these, pairs that may matter
  uint32_t leaf_pairs;      ///< of these, pairs of leaves ("leaf overlaps")
  uint32_t triangle_pairs;  ///< pairs of triangles that intersect ("geometry overlaps")
};

namespace detail {

/// Zeros, for -Os by four stores: memset() would take 160 bytes along.
FLASHBVH_INLINE inline Counts no_counts() {
  uint32_t none = 0;
#if defined(__OPTIMIZE_SIZE__) && defined(__GNUC__)
  __asm__("" : "+r"(none));
#endif
  return {none, none, none, none};
}

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

/// What a run of a walk may do and has done. Loops keep work and overlaps in registers.
struct Progress {
  uint32_t work_left;
  uint32_t overlaps = 0;
  uint32_t besides = 0;  ///< work that was not for visits

  void go_on(uint32_t left, uint32_t overlaps_so_far) {
    work_left = left;
    overlaps = overlaps_so_far;
  }
  /// On what is not a visit. The step that takes more than is left is done, and ends the run.
  void spend(uint32_t work) {
    const uint32_t spent = work < work_left ? work : work_left;
    work_left -= spent;
    besides += spent;
  }
  /// Counts down by one a visit, whatever else is done.
  uint32_t visits_down() const { return work_left + besides; }
};

/// Whether what is asked at pairs of leaves spends work.
template <class LeafPair, class = void>
struct SpendsWork {
  static constexpr bool kValue = false;
};
template <class LeafPair>
struct SpendsWork<LeafPair, typename LeafPair::SpendsWork> {
  static constexpr bool kValue = true;
};

/// A run of a walk. Its loop keeps but the address, and that in memory: registers are for the rest.
/// `leaf_pair(i, j, progress)`: of a pair of leaves that may matter, whether to go on after it; it
/// may spend work if it has a type SpendsWork, void.
template <class Cursor, class LeafPair>
struct WalkRun {
  WalkRun(Cursor& at, LeafPair& pair, uint32_t work)
      : cursor(&at), leaf_pair(&pair), progress{work} {}

  bool found(uint32_t a, uint32_t b) { return (*leaf_pair)(a, b, progress); }
  /// For a loop that keeps work and overlaps itself.
  bool found(uint32_t a, uint32_t b, uint32_t& work_left, uint32_t overlaps) {
    if constexpr (SpendsWork<LeafPair>::kValue) {
      progress.go_on(work_left, overlaps);
      const bool go_on = found(a, b);
      work_left = progress.work_left;
      return go_on;
    } else {
      Progress now{work_left, overlaps};
      return (*leaf_pair)(a, b, now);
    }
  }

  Cursor* cursor;
  LeafPair* leaf_pair;
  Progress progress;
  Side side = Side::none;  ///< of the leaf that it is below, if it is
  uint32_t leaf = 0;       ///< then: the leaf's node,
  uint32_t node = 0;       ///< and where it is in the other tree
};

/// The trees of a walk in which leaves are no shapes.
template <class TreeType>
struct NoShapes {
  using Tree = TreeType;
  static constexpr bool kShapes = false;
  static constexpr bool kAsksBound = false;
  static constexpr bool kKnowsRoot = false;
  const Tree& a;
  const Tree& b;

  template <class... Whatever>
  NoShapes(const Tree& tree_a, const Tree& tree_b, const Whatever&...) : a(tree_a), b(tree_b) {}
  template <class Bound>
  static void set_bound(Bound&) {}
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
/// the last of the work granted, or where `found(node)` says stop; there `at` is then. `after`: its
/// node was visited before.
template <class Subtree, class Shapes, class Found>
FLASHBVH_INLINE inline State visit_subtree(Subtree& at, const Shapes& shapes, Progress& progress,
                                           const Found& found, bool after) {
  uint32_t work_left = progress.work_left;
  uint32_t overlaps = progress.overlaps;
  State end = State::done;
  for (bool visit = !after;; visit = true) {
    if (visit) {
      if (work_left == 0) {
        end = State::at_pair;
        break;
      }
      --work_left;
      if (shapes.may_touch(at.node().box)) {
        ++overlaps;
        if (!at.node().is_leaf()) {
          at.descend();
          continue;
        }
        progress.go_on(work_left, overlaps);
        const bool go_on = found(at.index());
        work_left = progress.work_left;
        if (!go_on) {
          end = State::at_leaf_pair;
          break;
        }
      }
    }
    if (!at.next()) {
      break;
    }
  }
  progress.go_on(work_left, overlaps);
  return end;
}

/// A leaf, whose shape was begun, against the other tree's subtree below `root`; `after`: from
/// after its node on.
template <class Shapes, class Run>
FLASHBVH_NOINLINE State walk_below(Shapes& shapes, Run& run, uint32_t root, bool after) {
  using Tree = typename Shapes::Tree;
  Subtree<typename Tree::Index, Tree::kLayout> at(run.side == Side::a ? shapes.b : shapes.a, root,
                                                  run.node);
  const auto found = [&run](uint32_t other) {
    const bool leaf_is_a = run.side == Side::a;
    return run.found(leaf_is_a ? run.leaf : other, leaf_is_a ? other : run.leaf);
  };
  const State end = visit_subtree(at, shapes, run.progress, found, after);
  run.node = at.index();
  return end;
}

/// At a pair that may matter, one node or both leaves: to the end of what is below it.
template <class Node, class Shapes, class Run>
FLASHBVH_NOINLINE State reach_leaf(const Node* node_a, const Node* node_b, Shapes& shapes,
                                   Run& run) {
  const auto a = static_cast<uint32_t>(node_a - shapes.a.nodes);
  const auto b = static_cast<uint32_t>(node_b - shapes.b.nodes);
  const bool leaf_a = node_a->is_leaf();
  run.side = Side::none;
  if (leaf_a && node_b->is_leaf()) {
    ++run.progress.overlaps;
    return run.found(a, b) ? State::done : State::at_leaf_pair;
  }
  run.side = leaf_a ? Side::a : Side::b;
  run.leaf = leaf_a ? a : b;
  const uint32_t root = leaf_a ? b : a;
  run.node = (leaf_a ? shapes.b : shapes.a).first_child(root);
  run.progress.spend(shapes.work_of(run.side, run.leaf));
  if (!shapes.begin(run.side, run.leaf, &(leaf_a ? node_b : node_a)->box)) {
    return State::done;
  }
  ++run.progress.overlaps;
  return walk_below(shapes, run, root, false);
}

/// To the end of the leaf's walk in which this run's walk before stopped, below the root that was
/// kept: as in one go, with no look for what is left. Then the pair with that root is behind.
template <class Shapes, class Run>
FLASHBVH_INLINE inline State walk_to_root(Shapes& shapes, Run& run, bool after) {
  const uint32_t root = shapes.kept_root();
  const Side side = shapes.leaf_side();
  auto& leaf = side == Side::a ? run.cursor->a : run.cursor->b;
  auto& node = side == Side::a ? run.cursor->b : run.cursor->a;
  run.side = side;
  run.leaf = leaf;
  run.node = node;
  State end = walk_below(shapes, run, root, after);
  if (end == State::done) {
    run.node = root;
    run.side = Side::none;
    shapes.keep_root(0);
    end = State::at_leaf_pair;
  }
  node = static_cast<typename Shapes::Tree::Index>(run.node);
  return end;
}

/// To the end of the leaf's walk of a subtree that a walk was in, and of those that follow. Then
/// run.side is none. The first leaf is taken as a shape for nothing: a run with work always gets
/// on.
template <class Order, class Shapes, class Run>
FLASHBVH_NOINLINE State walk_on_below(Shapes& shapes, Run& run, bool after) {
  if constexpr (Shapes::kKnowsRoot && Order::kStackless && !Order::kBelowLeaves) {
    if (shapes.kept_root() != 0) {
      return walk_to_root(shapes, run, after);
    }
  }
  Order at(shapes.a, shapes.b, *run.cursor);
  for (;;) {
    const bool first = run.side == Side::none;
    run.side = at.leaf();
    if (run.side == Side::none || run.progress.work_left == 0) {
      break;
    }
    run.leaf = run.side == Side::a ? at.index_a() : at.index_b();
    run.node = at.leaf_node();
    const bool taken = shapes.is_taken(run.side, run.leaf);
    if (!first) {
      run.progress.spend(taken ? kGoOnWork : shapes.work_of(run.side, run.leaf));
    }
    if (!taken) {
      shapes.take_again(run.side, run.leaf);
      (void)shapes.begin(run.side, run.leaf, nullptr);
    }
    const State end = walk_below(shapes, run, at.leaf_root(), after);
    if (end != State::done) {
      at.store_below(*run.cursor, run.side, run.node);
      return end;
    }
    after = false;
    if (!at.next()) {
      at.store(*run.cursor, true);
      return State::done;
    }
    if (!Order::kStackless) {  // what comes next was on the stack
      run.side = Side::none;
      break;
    }
  }
  at.store(*run.cursor, false);
  return after ? State::at_leaf_pair : State::at_pair;
}

/// Of a walk at a pair below which it stopped, in the subtree of the node that is no leaf.
template <class Shapes, class Order>
FLASHBVH_INLINE inline void keep_root(Shapes& shapes, Side leaf, const Order& at) {
  if constexpr (Shapes::kKnowsRoot) {
    shapes.keep_root(leaf == Side::a ? at.index_b() : at.index_a());
  }
}

/// Whether neither node is a leaf: leaves' ranks are negative.
template <class Node>
FLASHBVH_INLINE inline bool are_inner(const Node& a, const Node& b) {
  return (a.rank() | b.rank()) >= 0;
}

/// From the cursor's pair, which is below no leaf that is a shape.
template <class Order, class Bound, class Shapes, class LeafPair>
FLASHBVH_NOINLINE State walk_pairs(const Bound& bound, Shapes& shapes,
                                   WalkRun<typename Order::Cursor, LeafPair>& run, bool after) {
  auto* kept = &run;
  keep_in_memory(kept);
  Bound may_matter = bound;
  put_in_place(may_matter);
  Order at(shapes.a, shapes.b, *run.cursor);
  uint32_t work_left = run.progress.work_left;
  uint32_t overlaps = run.progress.overlaps;
  State end = State::done;
  for (bool visit = !after;; visit = true) {
    if (visit) {
      if (work_left == 0) {
        end = State::at_pair;
        break;
      }
      --work_left;
      if (__builtin_expect(may_matter(at.node_a().box, at.node_b().box), 1)) {
        if constexpr (Shapes::kShapes) {
          if (are_inner(at.node_a(), at.node_b())) {
            ++overlaps;
            at.descend_inner();
            continue;
          }
          keep_in_memory(kept);
          kept->progress.go_on(work_left, overlaps);
          end = reach_leaf(&at.node_a(), &at.node_b(), shapes, *kept);
          keep_in_memory(kept);
          work_left = kept->progress.work_left;
          overlaps = kept->progress.overlaps;
          if (end != State::done && kept->side != Side::none) {
            keep_root(shapes, kept->side, at);
            at.store_below(*kept->cursor, kept->side, kept->node);
            return end;
          }
          if (end != State::done) {
            break;
          }
        } else {
          ++overlaps;
          if (at.descend()) {
            continue;
          }
          keep_in_memory(kept);
          if (!kept->found(at.index_a(), at.index_b(), work_left, overlaps)) {
            end = State::at_leaf_pair;
            break;
          }
        }
      }
    }
    if (!at.next()) {
      keep_in_memory(kept);  // and nothing of what comes then before the branch
      break;
    }
  }
  keep_in_memory(kept);
  at.store(*kept->cursor, end == State::done);
  kept->progress.go_on(work_left, overlaps);
  return end;
}

/// From the cursor, `from` a state that is not done, with some work granted, to where `leaf_pair`
/// says stop, the end, or the last of the work: where it stands then.
template <class Order, class Bound, class Shapes, class LeafPair>
FLASHBVH_INLINE inline State walk(const Bound& bound, Shapes& shapes,
                                  WalkRun<typename Order::Cursor, LeafPair>& run, State from) {
  if constexpr (Shapes::kShapes && Order::kBelowLeaves) {
    return walk_on_below<Order>(shapes, run, from == State::at_leaf_pair);
  } else {
    if constexpr (Shapes::kShapes) {
      if (from != State::fresh) {
        from = walk_on_below<Order>(shapes, run, from == State::at_leaf_pair);
        if (from == State::done || run.side != Side::none) {
          return from;
        }
      }
    }
    return walk_pairs<Order>(bound, shapes, run, from == State::at_leaf_pair);
  }
}

}  // namespace detail
}  // namespace flashbvh

#endif
