// The nearest pairs of nodes that a search has reached, in any parts of the trees.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/relative_distance.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// Begins with the roots. A full list drops its farthest pair. 100 bytes at most.
template <class Index>
class NearestPairs {
 public:
  struct Pair {
    uint16_t distance;
    Index nodes[2];  ///< of A and B
  };

  NearestPairs() { pair_[0] = {0, {0, 0}}; }
  bool is_empty() const { return count_ == 0; }
  Pair take() { return pair_[--count_]; }

  /// Adds the pairs of a node of `at` and the other's children that reach `window`, the node's.
  /// `side`, `nodes`: the other's index in `at`, and its tree.
  FLASHBVH_INLINE void open(Pair at, uint32_t side, const Node<Index>* nodes,
                            const PackedTriple& window) {
    const Index first = nodes[at.nodes[side] + 1u].link;
    Index child = first;
    do {
      const Node<Index>& node = nodes[child];
      if (reaches(node.box, window)) {
        at.distance = static_cast<uint16_t>(relative_distance(node.box, window).largest());
        at.nodes[side] = child;
        add(at);
      }
      child = node.link;
    } while (child != first);
  }

 private:
  static constexpr uint32_t kMost = sizeof(Index) == 2 ? 12 : 8;

  FLASHBVH_INLINE void add(const Pair& pair) {
    uint32_t i = 0;
    if (count_ == kMost) {
      if (pair_[0].distance <= pair.distance) {
        return;
      }
      for (; i + 1 != kMost && pair_[i + 1].distance > pair.distance; ++i) {
        pair_[i] = pair_[i + 1];
      }
    } else {
      for (i = count_++; i != 0 && pair_[i - 1].distance < pair.distance; --i) {
        pair_[i] = pair_[i - 1];
      }
    }
    pair_[i] = pair;
  }

  Pair pair_[kMost];  ///< the nearest last
  uint32_t count_ = 1;
};

}  // namespace flashbvh::detail
