// Pairs of leaves that a walk found and whose triangles are still to be tested: as many as a run
// takes along before it leaves the walk.
#ifndef FLASHBVH_DETAIL_LEAF_PAIRS_HPP
#define FLASHBVH_DETAIL_LEAF_PAIRS_HPP

#include <stdint.h>

#include "flashbvh/detail/walk.hpp"

namespace flashbvh::detail {

/// With each pair goes what the walk did to find it, so that counts are right at every pair.
/// 8 * size + 16 bytes with 16-bit indices.
template <class Index, uint32_t size>
class LeafPairs {
 public:
  struct Entry {
    Index a;
    Index b;
    uint16_t visits;
    uint16_t overlaps;
  };
  /// The most visits that a walk may make for one batch.
  static constexpr uint32_t kMostVisits = UINT16_MAX;

  void clear(const Progress& before) {
    count_ = next_ = 0;
    counted_ = before;
  }
  /// Whether there is room for another one.
  bool operator()(uint32_t a, uint32_t b, const Progress& progress) {
    Entry& entry = entry_[count_++];
    entry.a = static_cast<Index>(a);
    entry.b = static_cast<Index>(b);
    entry.visits = visits_until(progress);
    entry.overlaps = overlaps_until(progress);
    counted_ = progress;
    return count_ < size;
  }

  /// Where the walk ended.
  void end(const Progress& progress) { ended_ = progress; }

  bool has_next() const { return next_ < count_; }
  const Entry& next() { return entry_[next_++]; }
  /// The pair at hand.
  bool has_current() const { return next_ != 0; }
  const Entry& current() const { return entry_[next_ - 1]; }

  /// What the walk did after its last pair of leaves; once.
  Entry rest() {
    const Entry entry = {0, 0, visits_until(ended_), overlaps_until(ended_)};
    counted_ = ended_;
    return entry;
  }

 private:
  /// Since the last pair of leaves.
  uint16_t visits_until(const Progress& progress) const {
    return static_cast<uint16_t>(counted_.visits_left - progress.visits_left);
  }
  uint16_t overlaps_until(const Progress& progress) const {
    return static_cast<uint16_t>(progress.overlaps - counted_.overlaps);
  }

  Entry entry_[size];
  uint32_t count_ = 0;
  uint32_t next_ = 0;
  Progress counted_ = {0, 0};
  Progress ended_ = {0, 0};
};

}  // namespace flashbvh::detail

#endif
