// A run of a walk over pairs of nodes: its state, its budget and its progress.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/plain/results.h"

namespace flashbvh {

using QueryStats = flashbvh_stats;

/// The state of a walk.
enum class QueryState : uint8_t {
  fresh = 0,         ///< no visit was made
  at_pair = 1,       ///< the cursor's pair is to be visited next
  at_leaf_pair = 2,  ///< the cursor's pair, of leaves that may matter, was visited
  done = 3,          ///< every pair was visited
};

namespace detail {

using State = QueryState;

/// Zeros; at -Os by four stores, as memset() would add 160 bytes.
FLASHBVH_INLINE inline QueryStats no_counts() {
  uint32_t none = 0;
#if defined(__OPTIMIZE_SIZE__) && defined(__GNUC__)
  __asm__("" : "+r"(none));
#endif
  return {none, none, none, none};
}

/// The cursor of a stackless walk: one node of each tree, and nothing else.
template <class IndexType>
struct PairCursor {
  using Index = IndexType;
  Index a = 0;
  Index b = 0;

  /// True if the cursor has the memory that a walk over these trees needs.
  template <class Tree>
  bool fits(const Tree& /*a*/, const Tree& /*b*/) const {
    return true;
  }
};

/// The remaining work of a run and its counts. Loops keep work and overlaps in registers.
struct Progress {
  uint32_t work_left;
  uint32_t overlaps = 0;
  uint32_t other_work = 0;  ///< work spent on other steps than visits

  void go_on(uint32_t left, uint32_t overlaps_so_far) {
    work_left = left;
    overlaps = overlaps_so_far;
  }
  /// Spends work on a step other than a visit. A step that costs more than the rest is done, and
  /// ends the run.
  void spend(uint32_t work) {
    const uint32_t spent = work < work_left ? work : work_left;
    work_left -= spent;
    other_work += spent;
  }
  /// Decreases by one per visit, and by nothing else.
  uint32_t visits_down() const { return work_left + other_work; }
};

/// True if `leaf_pair` spends work.
template <class LeafPair, class = void>
struct SpendsWork {
  static constexpr bool kValue = false;
};
template <class LeafPair>
struct SpendsWork<LeafPair, typename LeafPair::SpendsWork> {
  static constexpr bool kValue = true;
};

/// A run of a walk. The walk's loop keeps only the run's address, in memory, to save registers.
/// `leaf_pair(i, j, progress)` gets each pair of leaves that may matter; false stops the walk. It
/// may spend work if it has a type SpendsWork, void.
template <class Cursor, class LeafPair>
struct WalkRun {
  WalkRun(Cursor& at, LeafPair& pair, uint32_t work)
      : cursor(&at), leaf_pair(&pair), progress{work} {}

  bool found(uint32_t a, uint32_t b) { return (*leaf_pair)(a, b, progress); }
  /// For a loop that keeps work and overlaps in registers.
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
  Side side = Side::none;  ///< of the leaf below which the walk is, if any;
  uint32_t leaf = 0;       ///< then the leaf's node,
  uint32_t node = 0;       ///< and the current node of the other tree
};

}  // namespace detail
}  // namespace flashbvh
