// The walk below a pair of which one node is a leaf.
//
// Once one node is a leaf, the rest below the pair is that leaf against a subtree, in any
// traversal. With leaf planes (`shapes`, leaf_planes.hpp) this walk has its own loop. There
// shapes.begin(side, node, box) makes the leaf current, and shapes.may_touch(box) tests the other
// tree's boxes. A leaf costs shapes.work_of(side, node). A run that resumes below a leaf first
// calls shapes.take_again(side, node). The state of this walk follows from the pair; a traversal
// with a stack leaves its stack unchanged meanwhile. Without leaf planes the traversal goes there
// as the paper has it. Leaf planes with kKnowsRoot store the node below which a walk stopped, for
// the next walk of the run. Leaf planes with kComparesLeaves also test the other leaf's triangles,
// by shapes.rejects_leaf(node, progress), which may spend work.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/walk/subtree.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"

namespace flashbvh::detail {

/// Visits nodes of a subtree, from `at` on, that may touch the current leaf. Stops at the end, when
/// the work is used up, or where `found(node)` returns false, and leaves `at` there. `after`: the
/// node at `at` was visited before.
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
        const bool go_on = found(at.node_index());
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

/// Walks the other tree's subtree below `root`, from run.node on, against a leaf after begin().
/// `after`: run.node was visited before.
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
  run.node = at.node_index();
  return end;
}

/// Handles a pair that may matter, of which one node is a leaf or both are. `fresh`: the caller
/// calls walk_below_reached() next, so that this frame is gone by then.
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

/// Does the walk that reach_leaf() leaves to its caller.
template <class Shapes, class Run>
FLASHBVH_NOINLINE State walk_below_reached(Shapes& shapes, Run& run) {
  const uint32_t root = run.node;
  run.node = (run.side == Side::a ? shapes.b : shapes.a).first_child(root);
  return walk_below(shapes, run, root, false);
}

/// Resumes the walk below a leaf in which this run's previous walk stopped, below the stored root,
/// without a search for the state. After its end, the pair with that root counts as visited.
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

/// For a traversal that stores more than a pair, and so the next one: resumes the walk below a
/// leaf, if there is one. The traversal is made again after it, which is cheaper than to keep it on
/// the stack.
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

/// Resumes the walk below a leaf, and does the walks below leaves that follow; run.side is then
/// none. The first leaf's planes are free of charge, so that any non-zero budget makes progress.
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
