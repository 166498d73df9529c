// The walk over pairs of nodes, one of A and one of B: one loop for all traversals. The walk below
// a leaf with leaf planes has another loop (walk_below.hpp).
//
// A traversal decides which pair comes next. It is a class that lives as long as a run, in
// registers:
//     Tree                    the trees: nodes, with levels if it needs them; a mesh is a tree
//     Cursor                  the state between runs; default: at the start
//     OfTranslations          the traversal where B is not rotated: itself, or another one
//     kStartsAtRoots          true if disjoint roots end the walk with the first visit
//     kStackless              true if a cursor is only a pair of nodes
//     kBelowLeaves            true if leaf() is never none
//     Order(a, b, cursor)     starts at the cursor's pair
//     node_a(), node_b()      the pair of nodes
//     index_a(), index_b()    their indices
//     descend()               moves to the first pair below this one; false at a pair of leaves
//     descend_inner(bound)    descend() at two internal nodes, whose boxes the box test tested
//                             last; unless kBelowLeaves
//     next()                  moves to the pair after this one's subtrees; false if there is none
//     leaf()                  the side of the leaf below which a run resumes, or none
//     leaf_root(), leaf_node()   the root and current node of that walk in the other tree
//     store(cursor, ended)    stores the state; `ended`: next() returned false
//     store_below(cursor, leaf, node)   stores the state of a walk below a leaf
// A stackless traversal also has, for cursors from outside whose indices are in range,
//     nodes(a, b, cursor)     the cursor's nodes
//     cursor_at(a, b, i, j)   the cursor of two nodes
//     can_visit(a, b, cursor) true if a walk over these meshes can reach the cursor
//
// A box test decides by two boxes whether their subtrees may matter: bound(box_a, box_b). The run
// holds a copy; a stateful box test is passed by a handle.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/walk/walk_below.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"

namespace flashbvh::detail {

/// The trees of a walk without leaf planes.
template <class TreeType>
struct NoShapes {
  using Tree = TreeType;
  static constexpr bool kShapes = false;
  static constexpr bool kReadsBoxTest = false;
  static constexpr bool kKnowsRoot = false;
  const Tree& a;
  const Tree& b;

  template <class... Arguments>
  NoShapes(const Tree& tree_a, const Tree& tree_b, const Arguments&...) : a(tree_a), b(tree_b) {}
  template <class BoxTest>
  static void set_box_test(BoxTest&) {}
};

/// The handle that passes a stateful box test to a walk.
template <class StatefulBoxTest>
struct ByReference {
  StatefulBoxTest* bound;
  bool operator()(const PackedBox& a, const PackedBox& b) const { return (*bound)(a, b); }
  PackedTriple window_of_a(const PackedBox& a) const { return bound->window_of_a(a); }
  PackedTriple window_of_b(const PackedBox& b) const { return bound->window_of_b(b); }
};

/// Makes the compiler assume that `object` may have changed: it can't live in registers across this
/// call.
template <class Object>
inline void keep_in_memory(Object& object) {
#if defined(__GNUC__)
  __asm__("" : "+m"(object));
#else
  (void)object;
#endif
}

/// A stateless box test stays in registers in a walk's loop; a handle, seldom read, goes to memory.
template <class BoxTest>
inline void put_in_place(BoxTest& /*bound*/) {}
template <class StatefulBoxTest>
inline void put_in_place(ByReference<StatefulBoxTest>& bound) {
  keep_in_memory(bound);
}

/// True if neither node is a leaf: leaves' ranks are negative.
template <class Node>
FLASHBVH_INLINE inline bool are_inner(const Node& a, const Node& b) {
  return (a.rank() | b.rank()) >= 0;
}

/// Moves below a pair that may matter; false at a pair of leaves and, with leaf planes, of one.
template <class Shapes, class Traversal, class BoxTest>
FLASHBVH_INLINE inline bool descend(Traversal& at, const BoxTest& may_matter) {
  if constexpr (Shapes::kShapes) {
    if (!are_inner(at.node_a(), at.node_b())) {
      return false;
    }
    at.descend_inner(may_matter);
    return true;
  } else {
    return at.descend();
  }
}

/// Handles a pair that may matter and below which descend() does not go. `done`: the walk goes on.
template <class Traversal, class Shapes, class Run>
FLASHBVH_INLINE inline State walk_leaf(const Traversal& at, Shapes& shapes, Run*& run,
                                       uint32_t& work_left, uint32_t& overlaps) {
  keep_in_memory(run);
  if constexpr (Shapes::kShapes) {
    run->progress.go_on(work_left, overlaps);
    State end = reach_leaf(&at.node_a(), &at.node_b(), shapes, *run);
    end = end == State::fresh ? walk_below_reached(shapes, *run) : end;
    keep_in_memory(run);
    work_left = run->progress.work_left;
    overlaps = run->progress.overlaps;
    return end;
  } else {
    ++overlaps;
    return run->found(at.index_a(), at.index_b(), work_left, overlaps) ? State::done
                                                                       : State::at_leaf_pair;
  }
}

/// Stores the state of a walk that walk_leaf() stopped below a leaf; false if it stopped elsewhere.
template <class Traversal, class Shapes, class Run>
FLASHBVH_INLINE inline bool store_below_leaf(const Traversal& at, Shapes& shapes, Run& run) {
  if constexpr (Shapes::kShapes) {
    if (run.side != Side::none) {
      if constexpr (Shapes::kKnowsRoot) {
        shapes.keep_root(run.side == Side::a ? at.index_b() : at.index_a());
      }
      at.store_below(*run.cursor, run.side, run.node);
      return true;
    }
  }
  return false;
}

/// Walks from the cursor's pair, which is not below a leaf with leaf planes.
template <class Traversal, class BoxTest, class Shapes, class Run>
FLASHBVH_NOINLINE State walk_pairs(const BoxTest& bound, Shapes& shapes, Run& run, bool after) {
  auto* kept = &run;
  keep_in_memory(kept);
  BoxTest may_matter = bound;
  put_in_place(may_matter);
  Traversal at(shapes.a, shapes.b, *run.cursor);
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
        if (descend<Shapes>(at, may_matter)) {
          ++overlaps;
          continue;
        }
        end = walk_leaf(at, shapes, kept, work_left, overlaps);
        if (end != State::done) {
          if (store_below_leaf(at, shapes, *kept)) {
            return end;
          }
          break;
        }
      }
    }
    if (!at.next()) {
      keep_in_memory(kept);  // no later code moves before the branch
      break;
    }
  }
  keep_in_memory(kept);
  at.store(*kept->cursor, end == State::done);
  kept->progress.go_on(work_left, overlaps);
  return end;
}

/// Walks from the cursor until `leaf_pair` stops the walk, all pairs are visited or the work is
/// used up. Needs work, and a state `from` other than `done`. Returns the new state.
template <class Traversal, class BoxTest, class Shapes, class Run>
FLASHBVH_INLINE inline State walk(const BoxTest& bound, Shapes& shapes, Run& run, State from) {
  if constexpr (Shapes::kShapes && Traversal::kBelowLeaves) {
    return walk_on_below<Traversal>(shapes, run, from == State::at_leaf_pair);
  } else {
    if constexpr (Shapes::kShapes) {
      if (from != State::fresh) {
        from = walk_on_below<Traversal>(shapes, run, from == State::at_leaf_pair);
        if (from == State::done || run.side != Side::none) {
          return from;
        }
      }
    }
    return walk_pairs<Traversal>(bound, shapes, run, from == State::at_leaf_pair);
  }
}

}  // namespace flashbvh::detail
