// A run of a walk over pairs of nodes: where it stands, what it may do and what it has done.
#ifndef FLASHBVH_DETAIL_WALK_WALK_RUN_HPP
#define FLASHBVH_DETAIL_WALK_WALK_RUN_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/plain/results.h"

namespace flashbvh {

using QueryStats = flashbvh_stats;

/// Where a walk stands.
enum class QueryState : uint8_t {
  fresh = 0,         ///< no visit was made
  at_pair = 1,       ///< the cursor's pair is to be visited next
  at_leaf_pair = 2,  ///< the cursor is at a pair of leaves that may matter, which was visited
  done = 3,          ///< every pair was visited
};

namespace detail {

using State = QueryState;

/// Zeros, for -Os by four stores: memset() would take 160 bytes along.
FLASHBVH_INLINE inline QueryStats no_counts() {
  uint32_t none = 0;
#if defined(__OPTIMIZE_SIZE__) && defined(__GNUC__)
  __asm__("" : "+r"(none));
#endif
  return {none, none, none, none};
}

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
  /// QueryStats down by one a visit, whatever else is done.
  uint32_t visits_down() const { return work_left + besides; }
};

/// Whether the tests at pairs of leaves spend work.
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

}  // namespace detail
}  // namespace flashbvh

#endif
