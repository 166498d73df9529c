// The traversal of a search for any one pair. It is Ranked, but where B is rotated a walk goes to
// the nearest child first, and skips children that one box test rejects.
//
// The remaining children are no function of the pair. So each level stores four bits. Three are for
// the siblings that follow on the ring, which leads from the last child to the first. One selects
// Ranked's order: for a node with more than four children. Nodes more than eight descents below the
// roots use Ranked's order, too.
//
// Under a translation the traversal is Ranked: visits are so cheap there that looking ahead costs
// more than it saves. lib/docs/decisions.md has figures.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/relative_distance.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/traversal/ranked.hpp"

namespace flashbvh::detail {

template <class TreeType>
class NearFirst : public Ranked<TreeType> {
  using Base = Ranked<TreeType>;
  using Index = typename TreeType::Index;
  using Base::a_, Base::b_;
  using typename Base::Place;

 public:
  using Tree = TreeType;
  using OfTranslations = Base;
  static constexpr bool kStackless = false;

  struct Cursor : PairCursor<Index> {
    uint32_t left = 0;    ///< remaining siblings; the low four bits are the lowest level's
    uint32_t levels = 0;  ///< descents from the roots
    Index below = 0;      ///< the other tree's node in a walk below the leaf
    Side leaf = Side::none;
  };

  /// A cursor at the roots for a walk in Ranked's order, for meshes that seldom intersect.
  static Cursor as_ranked() {
    Cursor cursor;
    cursor.levels = kLevels;
    return cursor;
  }

  /// The remaining siblings of each level stay in the cursor.
  NearFirst(const Tree& a, const Tree& b, Cursor& cursor) : Base(a, b, cursor), kept_(cursor) {}

  /// `bound`: the box test, which has just found that the pair's boxes overlap.
  template <class Bound>
  FLASHBVH_INLINE void descend_inner(const Bound& bound) {
    const int32_t rank_a = a_.node->rank();
    const int32_t rank_b = b_.node->rank();
    if (rank_a < rank_b) {
      descend(b_, rank_b, bound.window_of_a(a_.node->box));
    } else {
      descend(a_, rank_a, bound.window_of_b(b_.node->box));
    }
  }

  bool next() {
    for (;;) {
      Place& at = b_.parent_rank <= a_.parent_rank ? b_ : a_;
      const bool is_kept = kept_.levels <= kLevels;
      const uint32_t left = is_kept ? kept_.left & kOneLevel : kAsRanked;
      if (left == kAsRanked) {
        if (at.next_sibling()) {
          return true;
        }
      } else if (left != 0) {
        kept_.left = kept_.left - left + pass_siblings(at, left);
        return true;
      } else if (at.node == at.root) {
        return false;
      }
      at.skip_siblings();
      at.ascend();
      kept_.left >>= is_kept ? kBits : 0;
      --kept_.levels;
    }
  }

  Side leaf() const { return kept_.leaf; }
  uint32_t leaf_root() const { return leaf() == Side::a ? this->index_b() : this->index_a(); }
  uint32_t leaf_node() const { return kept_.below; }
  void store(Cursor& cursor, bool /*ended*/) const { store_below(cursor, Side::none, 0); }
  void store_below(Cursor& cursor, Side leaf, uint32_t node) const {
    Base::store(cursor, false);
    cursor.leaf = leaf;
    cursor.below = static_cast<Index>(node);
  }

 private:
  static constexpr uint32_t kMostChildren = 4;
  static constexpr uint32_t kAsRanked = 1u << (kMostChildren - 1);  ///< above the siblings' bits
  static constexpr uint32_t kBits = kMostChildren;                  ///< per level
  static constexpr uint32_t kLevels = 32 / kBits;
  static constexpr uint32_t kOneLevel = (1u << kBits) - 1;

  /// Moves to the next remaining sibling. Returns the siblings that remain after it.
  FLASHBVH_INLINE static uint32_t pass_siblings(Place& at, uint32_t left) {
    bool is_left = false;
    do {
      at.node = at.root + at.node->link;
      is_left = (left & 1) != 0;
      left >>= 1;
    } while (!is_left);
    return left;
  }

  FLASHBVH_NOINLINE void descend(Place& at, int32_t rank, const PackedTriple& window) {
    at.descend(rank);
    if (++kept_.levels <= kLevels) {
      kept_.left = kept_.left << kBits | begin_nearest(at, window);
    }
  }
  /// Moves from a first child to the nearest that reaches the other node's window. Returns the
  /// remaining siblings.
  FLASHBVH_INLINE static uint32_t begin_nearest(Place& at, const PackedTriple& window) {
    const auto* const first = at.node;
    const auto* child = first;
    uint32_t children = 0;
    uint32_t overlapping = 0;
    uint32_t least = UINT32_MAX;
    uint32_t nearest = 0;
    do {
      if (children == kMostChildren) {
        at.node = first;
        return kAsRanked;
      }
      if (reaches(child->box, window)) {
        overlapping |= 1u << children;
        const uint32_t distance = relative_distance(child->box, window).squared();
        if (distance < least) {
          least = distance;
          nearest = children;
          at.node = child;
        }
      }
      ++children;
      child = at.root + child->link;
    } while (child != first);
    const uint32_t round = overlapping | overlapping << children;
    return round >> (nearest + 1) & ((1u << (children - 1)) - 1);
  }

  Cursor& kept_;
};

}  // namespace flashbvh::detail
