// The walk over pairs of nodes, one of A and one of B: one loop for every order. What lies below a
// leaf that is taken as a shape has another one (walk_below.hpp).
//
// An order says which pair comes next. It is a class that lives as long as a run, in registers:
//     Tree                    what it walks: nodes, with levels if it needs them; a mesh is a tree
//     Cursor                  where a walk is between runs; default: at its start
//     OfTranslations          the order where B is not rotated: itself, or another one
//     kStartsAtRoots          whether roots that are disjoint end it with the first visit
//     kStackless              whether a cursor is no more than a pair of nodes
//     kBelowLeaves            whether leaf() is never none
//     Order(a, b, cursor)     at the cursor's pair
//     node_a(), node_b()      the pair of nodes
//     index_a(), index_b()    their indices
//     descend()               to the first pair below this one; false at a pair of leaves
//     descend_inner(bound)    the same of a pair of which none is a leaf, unless kBelowLeaves, and
//                             whose boxes the bound saw last
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
#ifndef FLASHBVH_DETAIL_WALK_WALK_HPP
#define FLASHBVH_DETAIL_WALK_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/walk/walk_below.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"

namespace flashbvh::detail {

/// The trees of a walk in which leaves are no shapes.
template <class TreeType>
struct NoShapes {
  using Tree = TreeType;
  static constexpr bool kShapes = false;
  static constexpr bool kReadsBoxTest = false;
  static constexpr bool kKnowsRoot = false;
  const Tree& a;
  const Tree& b;

  template <class... Whatever>
  NoShapes(const Tree& tree_a, const Tree& tree_b, const Whatever&...) : a(tree_a), b(tree_b) {}
  template <class BoxTest>
  static void set_box_test(BoxTest&) {}
};

/// A bound that has a state, as a walk takes it: by a handle.
template <class StatefulBoxTest>
struct ByReference {
  StatefulBoxTest* bound;
  bool operator()(const PackedBox& a, const PackedBox& b) const { return (*bound)(a, b); }
  PackedBox seen_a() const { return bound->seen_a(); }
  PackedBox seen_b() const { return bound->seen_b(); }
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

/// A bound of its own has its registers in a walk's loop; a handle is seldom read, and leaves them.
template <class BoxTest>
inline void put_in_place(BoxTest& /*bound*/) {}
template <class StatefulBoxTest>
inline void put_in_place(ByReference<StatefulBoxTest>& bound) {
  keep_in_memory(bound);
}

/// Of a walk at a pair below which it stopped, in the subtree of the node that is no leaf.
template <class Shapes, class Traversal>
FLASHBVH_INLINE inline void keep_root(Shapes& shapes, Side leaf, const Traversal& at) {
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
        if constexpr (Shapes::kShapes) {
          if (are_inner(at.node_a(), at.node_b())) {
            ++overlaps;
            at.descend_inner(may_matter);
            continue;
          }
          keep_in_memory(kept);
          kept->progress.go_on(work_left, overlaps);
          end = reach_leaf(&at.node_a(), &at.node_b(), shapes, *kept);
          end = end == State::fresh ? walk_below_reached(shapes, *kept) : end;
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
      keep_in_memory(kept);  // and nothing that follows before the branch
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

#endif
