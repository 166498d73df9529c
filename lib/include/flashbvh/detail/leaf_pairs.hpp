// Pairs of leaves that a walk found and whose triangles are still to be tested: as many as a run
// takes along before it leaves the walk.
#ifndef FLASHBVH_DETAIL_LEAF_PAIRS_HPP
#define FLASHBVH_DETAIL_LEAF_PAIRS_HPP

#include <stdint.h>

#include "flashbvh/detail/walk.hpp"

namespace flashbvh::detail {

/// With each pair goes where the walk's counts stood, so that counts are right at every pair.
/// 8 * size + 20 bytes with 16-bit indices.
template <class Index, uint32_t size>
class LeafPairs {
 public:
  struct Entry {
    Index a;
    Index b;
    uint32_t counts;
  };
  /// Visits, and of these overlaps.
  struct Walked {
    uint32_t visits;
    uint32_t overlaps;
  };
  /// The most visits that a walk may make for one batch: counts keep 16 bits.
  static constexpr uint32_t kMostVisits = UINT16_MAX;

  /// `room`: for how many pairs, at least one.
  void clear(const Progress& before, uint32_t room) {
    count_ = next_ = 0;
    room_ = room < size ? room : size;
    counted_ = halves(before);
  }
  /// Whether there is room for another one.
  bool operator()(uint32_t a, uint32_t b, const Progress& progress) {
    Entry& entry = entry_[count_++];
    entry.a = static_cast<Index>(a);
    entry.b = static_cast<Index>(b);
    entry.counts = halves(progress);
    return count_ < room_;
  }
  /// Where the walk ended.
  void end(const Progress& progress) { ended_ = halves(progress); }

  bool has_next() const { return next_ < count_; }
  const Entry& next() { return entry_[next_++]; }
  /// The pair at hand.
  bool has_current() const { return next_ != 0; }
  const Entry& current() const { return entry_[next_ - 1]; }

  /// What the walk did since this was asked before, up to the pair at hand; or up to its end.
  Walked walked_to_current() { return since(current().counts); }
  Walked walked_to_end() { return since(ended_); }

 private:
  static uint32_t halves(const Progress& progress) {
    return join_halves(low_half(progress.visits_left), progress.overlaps);
  }
  Walked since(uint32_t counts) {
    const Walked walked = {low_half(counted_ - counts),
                           low_half(high_half(counts) - high_half(counted_))};
    counted_ = counts;
    return walked;
  }

  Entry entry_[size];
  uint32_t room_ = size;
  uint32_t count_ = 0;
  uint32_t next_ = 0;
  uint32_t counted_ = 0;
  uint32_t ended_ = 0;
};

}  // namespace flashbvh::detail

#endif
