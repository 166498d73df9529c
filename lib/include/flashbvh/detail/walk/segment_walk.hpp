// The walk of a segment through one tree, from hit to hit.
#ifndef FLASHBVH_DETAIL_WALK_SEGMENT_WALK_HPP
#define FLASHBVH_DETAIL_WALK_SEGMENT_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/walk/subtree.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

template <class Index>
struct RayHit;

namespace detail {

/// A segment, and the part of it that still matters, against boxes.
class SegmentInBoxes {
 public:
  /// On the boxes' lattice, within 2^20 cells.
  explicit SegmentInBoxes(const Segment& segment);

  /// Whether the segment's line and the part's box have a point of the box: true wherever the part
  /// has, by the six axes on which a segment and a box can be apart.
  bool may_meet(const PackedBox& box) const;

  /// What lies behind this share doesn't matter any more.
  void shorten(const SegmentShare& along);

 private:
  int32_t from_[3];
  int32_t way_[3];
  int32_t upper_[3];  ///< of the part
  int32_t lower_[3];
};

/// From one triangle near a segment to the next.
template <class MeshType>
class SegmentWalk {
 public:
  using Index = typename MeshType::Index;

  /// `segment`: in the mesh's frame.
  SegmentWalk(const MeshType& mesh, const Segment& segment) noexcept;

  /// To the next triangle that is hit; false at the end, and after an error, which status()
  /// returns.
  bool next(RayHit<Index>& hit) noexcept;
  /// To the next one whose leaf's box the segment meets.
  bool next_triangle(uint32_t& position) noexcept;
  /// From the mesh's origin on.
  void get_triangle(uint32_t position, Triangle& t) const noexcept;

  /// Whether a triangle is hit.
  bool get_hit(uint32_t position, RayHit<Index>& hit) const noexcept;
  void shorten(const SegmentShare& along) noexcept { boxes_.shorten(along); }

  const Segment& segment() const { return segment_; }
  Status status() const { return status_; }
  uint32_t visits() const { return visits_; }

 private:
  /// To the first triangle of the next leaf.
  bool next_leaf() noexcept;

  Status status_ = Status::done;  // set by the segment: before it
  const MeshType* mesh_;
  Segment segment_;  ///< from the mesh's origin on
  SegmentInBoxes boxes_;
  Subtree<Index, MeshType::kLayout> at_;
  uint32_t visits_ = 0;
  uint32_t triangle_ = 0;  ///< of the leaf that the walk is at
  uint32_t end_ = 0;
  bool is_over_ = false;
};

}  // namespace detail
}  // namespace flashbvh

#endif
