// The walk of a segment through one tree, from hit to hit.
#pragma once

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

/// Tests boxes against the part of a segment that still matters.
class SegmentInBoxes {
 public:
  /// `segment`: on the boxes' lattice, within 2^20 cells.
  explicit SegmentInBoxes(const Segment& segment);

  /// True if the box meets both the segment's line and the part's bounding box, hence wherever it
  /// meets the part. Tests the six axes on which a segment and a box can be apart.
  bool may_meet(const PackedBox& box) const;

  /// Cuts the part off at this share of the segment.
  void shorten(const SegmentShare& along);

 private:
  int32_t from_[3];
  int32_t way_[3];
  int32_t upper_[3];  ///< bounds of the part
  int32_t lower_[3];
};

/// Walks from one triangle near a segment to the next.
template <class MeshType>
class SegmentWalk {
 public:
  using Index = typename MeshType::Index;

  /// `segment`: in the mesh's frame.
  SegmentWalk(const MeshType& mesh, const Segment& segment) noexcept;

  /// Moves to the next triangle that the segment hits; false at the end and after an error, which
  /// status() returns.
  bool next(RayHit<Index>& hit) noexcept;
  /// Moves to the next triangle whose leaf's box the segment meets.
  bool next_triangle(uint32_t& position) noexcept;
  /// Gets a triangle relative to the mesh's origin.
  void get_triangle(uint32_t position, Triangle& t) const noexcept;

  /// True if the segment hits the triangle.
  bool get_hit(uint32_t position, RayHit<Index>& hit) const noexcept;
  void shorten(const SegmentShare& along) noexcept { boxes_.shorten(along); }

  const Segment& segment() const { return segment_; }
  Status status() const { return status_; }
  uint32_t visits() const { return visits_; }

 private:
  /// Moves to the first triangle of the next leaf.
  bool next_leaf() noexcept;

  Status status_ = Status::done;  // before segment_, whose initialiser sets it
  const MeshType* mesh_;
  Segment segment_;  ///< relative to the mesh's origin
  SegmentInBoxes boxes_;
  Subtree<Index, MeshType::kLayout> at_;
  uint32_t visits_ = 0;
  uint32_t triangle_ = 0;  ///< in the current leaf
  uint32_t end_ = 0;
  bool is_over_ = false;
};

}  // namespace detail
}  // namespace flashbvh
