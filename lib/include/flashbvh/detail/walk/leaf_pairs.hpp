// A batch of leaf pairs: a walk collects them; then their triangles are tested outside the walk.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// A pair of leaves pays for all its pairs of triangles when it is found: no walk finds it again
/// for lack of work. A pair that exceeds the work ends the walk; it is tested after the batch.
///
/// Each pair stores the walk's counts, so that counts are right at each pair.
/// 8 * size + 16 bytes with 16-bit indices.
template <class Mesh, uint32_t size, uint32_t pair_work>
class LeafPairs {
  using Index = typename Mesh::Index;

 public:
  using SpendsWork = void;

  struct Entry {
    Index a;
    Index b;
    uint32_t counts;
  };
  /// Visits, and those that found an overlap.
  struct Walked {
    uint32_t visits;
    uint32_t overlaps;
  };
  /// The most work of a walk for one batch: counts have 16 bits.
  static constexpr uint32_t kMostWork = UINT16_MAX;
  /// The most pairs of a query's first batch.
  static constexpr uint32_t kFirst = 3;

  LeafPairs(const Mesh& a, const Mesh& b)
      : a_(a.leaf_offsets == nullptr && b.leaf_offsets == nullptr ? nullptr : &a), b_(&b) {
    entry_[0].counts = 0;
  }

  /// `room`: the capacity for pairs of triangles, at least 1. `first`: for a query's first batch,
  /// as its first answer may be the only one that the caller needs.
  void clear(const Progress& before, uint32_t room, bool first) {
    // With several triangles per leaf, most leaf pairs have four pairs of triangles. A larger batch
    // would be walked again.
    const uint32_t pairs = a_ == nullptr ? room : room / 4 + 1;
    count_ = next_ = 0;
    unpaid_ = false;
    const uint32_t most = first && kFirst < size ? kFirst : size;
    room_ = static_cast<uint8_t>(pairs < most ? pairs : most);
    counted_ = halves(before);
  }
  /// Adds a pair. True if the work covers it and the batch has capacity for another pair.
  FLASHBVH_NOINLINE bool operator()(uint32_t a, uint32_t b, Progress& progress) {
    uint32_t work = pair_work;
    if (a_ != nullptr) {
      work *= triangle_pairs(a_->nodes[a].leaf(), b_->nodes[b].leaf());
    }
    Entry& entry = entry_[count_];
    entry.a = static_cast<Index>(a);
    entry.b = static_cast<Index>(b);
    entry.counts = halves(progress);
    if (progress.work_left < work) {
      unpaid_ = true;
      return false;
    }
    progress.work_left -= work;
    progress.other_work += work;
    return ++count_ != room_;
  }
  /// Stores the counts at the walk's end.
  void end(const Progress& progress) {
    if (count_ < size) {
      entry_[count_].counts = halves(progress);
    }
  }

  /// The number of pairs of triangles of two leaves.
  uint32_t triangle_pairs(uint32_t leaf_a, uint32_t leaf_b) const {
    return a_ == nullptr ? 1 : a_->triangles_in(leaf_a) * b_->triangles_in(leaf_b);
  }

  bool is_walked() const { return room_ != 0; }
  bool has_next() const { return next_ < count_; }
  /// True if the next pair is the last and was not paid for.
  bool has_unpaid() const { return unpaid_ && next_ == count_; }
  const Entry& next() { return entry_[next_++]; }
  /// The current pair.
  bool has_current() const { return next_ != 0; }
  const Entry& current() const { return entry_[next_ - 1]; }

  /// The walk's visits and overlaps since the last call, up to the current pair or the walk's end.
  Walked walked_to_current() { return since(current().counts); }
  Walked walked_to_end() { return since(entry_[count_ < size ? count_ : size - 1].counts); }

 private:
  static uint32_t halves(const Progress& progress) {
    return join_halves(low_half(progress.visits_down()), progress.overlaps);
  }
  Walked since(uint32_t counts) {
    const Walked walked = {low_half(counted_ - counts),
                           low_half(high_half(counts) - high_half(counted_))};
    counted_ = counts;
    return walked;
  }

  const Mesh* a_;  ///< null: one triangle in each leaf
  const Mesh* b_;
  uint8_t room_ = 0;  ///< capacity for the walk's pairs; 0 before a walk
  uint8_t count_ = 0;
  uint8_t next_ = 0;
  bool unpaid_ = false;
  uint32_t counted_ = 0;
  Entry entry_[size];  ///< a free entry after the last pair has the walk's final counts
};

}  // namespace flashbvh::detail
