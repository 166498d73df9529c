// Pairs of leaves that a walk found and whose triangles are still to be tested: as many as a run
// batches before it leaves the walk.
#ifndef FLASHBVH_DETAIL_WALK_LEAF_PAIRS_HPP
#define FLASHBVH_DETAIL_WALK_LEAF_PAIRS_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// A pair of leaves is paid for when it is found, with all its pairs of triangles, so that none is
/// walked to again for want of work. One that can't be paid for ends the walk and is not taken
/// along: it is tested in turn.
///
/// With each pair goes where the walk's counts stood, so that counts are right at every pair.
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
  /// Visits, and of these overlaps.
  struct Walked {
    uint32_t visits;
    uint32_t overlaps;
  };
  /// The most work of a walk for one batch: counts keep 16 bits.
  static constexpr uint32_t kMostWork = UINT16_MAX;
  /// The most pairs of a query's first batch.
  static constexpr uint32_t kFirst = 3;

  LeafPairs(const Mesh& a, const Mesh& b)
      : a_(a.leaf_offsets == nullptr && b.leaf_offsets == nullptr ? nullptr : &a), b_(&b) {
    entry_[0].counts = 0;
  }

  /// `room`: for how many pairs of triangles, at least one. `first`: of the query, whose first
  /// answer may be all that is wanted.
  void clear(const Progress& before, uint32_t room, bool first) {
    // Leaves of several triangles: four pairs each, as most have. More only cost a walk again.
    const uint32_t pairs = a_ == nullptr ? room : room / 4 + 1;
    count_ = next_ = 0;
    unpaid_ = false;
    const uint32_t most = first && kFirst < size ? kFirst : size;
    room_ = static_cast<uint8_t>(pairs < most ? pairs : most);
    counted_ = halves(before);
  }
  /// Whether to go on: this one could be paid for, and there is room for another one.
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
    progress.besides += work;
    return ++count_ != room_;
  }
  /// Where the walk ended.
  void end(const Progress& progress) {
    if (count_ < size) {
      entry_[count_].counts = halves(progress);
    }
  }

  /// How many pairs of triangles two leaves have.
  uint32_t triangle_pairs(uint32_t leaf_a, uint32_t leaf_b) const {
    return a_ == nullptr ? 1 : a_->triangles_in(leaf_a) * b_->triangles_in(leaf_b);
  }

  bool is_walked() const { return room_ != 0; }
  bool has_next() const { return next_ < count_; }
  /// Whether the next one, the last, was not paid for.
  bool has_unpaid() const { return unpaid_ && next_ == count_; }
  const Entry& next() { return entry_[next_++]; }
  /// The current pair.
  bool has_current() const { return next_ != 0; }
  const Entry& current() const { return entry_[next_ - 1]; }

  /// What the walk did since the call before, up to the current pair; or up to its end.
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
  uint8_t room_ = 0;  ///< of the walk, if there was one
  uint8_t count_ = 0;
  uint8_t next_ = 0;
  bool unpaid_ = false;
  uint32_t counted_ = 0;
  Entry entry_[size];  ///< after the last one: where the walk ended, if it was not there
};

}  // namespace flashbvh::detail

#endif
