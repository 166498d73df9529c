// What is left of a walk below a pair of which one node is a leaf.
//
// Once one node is a leaf, all that is left below the pair is that leaf against a subtree, whatever
// the order. If leaves are taken as shapes (leaf_planes.hpp), that has a loop of its own, in which
// shapes.begin(side, node, box) takes the leaf, after shapes.take_again(side, node) if a run goes
// on below it; it is shapes.work_of(side, node). And shapes.may_touch(box) tests the other tree's
// boxes; where a walk is in it follows from the pair. An order with a stack leaves it alone
// meanwhile. Without shapes the order goes there as the paper has it. Shapes that have kKnowsRoot
// keep below which node a walk stopped, for the next one of the same run. Those that have
// kComparesLeaves look at the triangles of the other leaf, too, by shapes.rejects_leaf(node,
// progress), which may spend work.
#ifndef FLASHBVH_DETAIL_WALK_WALK_BELOW_HPP
#define FLASHBVH_DETAIL_WALK_WALK_BELOW_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/walk/subtree.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"

namespace flashbvh::detail {

/// Visits nodes of a subtree, from `at` on, that may touch the shape that was begun, until the end,
/// the last of the work granted, or where `found(node)` says stop; there `at` is then. `after`: its
/// node was visited before.
template <class Subtree, class Shapes, class Found>
FLASHBVH_INLINE inline State visit_subtree(Subtree& at, Shapes& shapes, Progress& progress,
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
  const auto found = [&](uint32_t other) {
    if constexpr (Shapes::kComparesLeaves) {
      if (shapes.rejects_leaf(other, run.progress)) {
        return true;
      }
    }
    const bool leaf_is_a = run.side == Side::a;
    return run.found(leaf_is_a ? run.leaf : other, leaf_is_a ? other : run.leaf);
  };
  const State end = visit_subtree(at, shapes, run.progress, found, after);
  run.node = at.index();
  return end;
}

/// At a pair that may matter, one node or both leaves. `fresh`: walk_below_reached() is next,
/// called by the caller, so that no frame of this lies above it.
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
  run.node = leaf_a ? b : a;
  run.progress.spend(shapes.work_of(run.side, run.leaf));
  if (!shapes.begin(run.side, run.leaf, &(leaf_a ? node_b : node_a)->box)) {
    return State::done;
  }
  ++run.progress.overlaps;
  return State::fresh;
}

/// The walk that reach_leaf() left.
template <class Shapes, class Run>
FLASHBVH_NOINLINE State walk_below_reached(Shapes& shapes, Run& run) {
  const uint32_t root = run.node;
  run.node = (run.side == Side::a ? shapes.b : shapes.a).first_child(root);
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

/// Of an order that keeps more than a pair, and so what comes next: to the end of the leaf's walk,
/// if there is one. The order is made once more after it, which is cheaper than to keep it on the
/// stack.
template <class Traversal, class Shapes, class Run>
FLASHBVH_NOINLINE State walk_on_below_one(Shapes& shapes, Run& run, bool after) {
  uint32_t root = 0;
  {
    Traversal at(shapes.a, shapes.b, *run.cursor);
    run.side = at.leaf();
    if (run.side == Side::none) {
      return after ? State::at_leaf_pair : State::at_pair;
    }
    run.leaf = run.side == Side::a ? at.index_a() : at.index_b();
    run.node = at.leaf_node();
    root = at.leaf_root();
  }
  if (!shapes.is_taken(run.side, run.leaf)) {
    shapes.take_again(run.side, run.leaf);
    (void)shapes.begin(run.side, run.leaf, nullptr);
  }
  State end = walk_below(shapes, run, root, after);
  Traversal at(shapes.a, shapes.b, *run.cursor);
  if (end != State::done) {
    at.store_below(*run.cursor, run.side, run.node);
    return end;
  }
  if (at.next()) {
    run.side = Side::none;
    end = State::at_pair;
  }
  at.store(*run.cursor, end == State::done);
  return end;
}

/// To the end of the leaf's walk of a subtree that a walk was in, and of those that follow. Then
/// run.side is none. The first leaf is taken as a shape for nothing: a run with work always gets
/// on.
template <class Traversal, class Shapes, class Run>
FLASHBVH_NOINLINE State walk_on_below(Shapes& shapes, Run& run, bool after) {
  if constexpr (Shapes::kKnowsRoot && Traversal::kStackless && !Traversal::kBelowLeaves) {
    if (shapes.kept_root() != 0) {
      return walk_to_root(shapes, run, after);
    }
  }
  if constexpr (!Traversal::kStackless) {
    return walk_on_below_one<Traversal>(shapes, run, after);
  }
  Traversal at(shapes.a, shapes.b, *run.cursor);
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
  }
  at.store(*run.cursor, false);
  return after ? State::at_leaf_pair : State::at_pair;
}

}  // namespace flashbvh::detail

#endif
