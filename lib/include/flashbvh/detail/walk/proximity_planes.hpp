// Leaf planes for predicates of distance: lower bounds on the distance of a leaf's triangles to
// boxes of the other tree. leaf_planes.hpp has those for intersection.
//
// The leaf's own box, seen from the other tree, bounds the distance along that tree's axes. The
// normal of its plane, and in that plane the normal of its longest edge, bound it along two more
// directions, whose squared gaps add up against a limit larger by one part in 2^9.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/gap.hpp"
#include "flashbvh/detail/walk/leaf_planes.hpp"

namespace flashbvh::detail {

template <class Mesh>
class ProximityPlanes : LeafPlanes<Mesh> {
  using Base = LeafPlanes<Mesh>;

 public:
  using Tree = Mesh;
  static constexpr bool kShapes = true;
  static constexpr bool kReadsBoxTest = true;
  static constexpr bool kComparesLeaves = false;

  ProximityPlanes(const Mesh& mesh_a, const Mesh& mesh_b, const Transform& transform)
      : Base(mesh_a, mesh_b, transform) {}

  using Base::a;
  using Base::b;
  using Base::is_taken;
  using Base::keep_root;
  using Base::kept_root;
  using Base::kKnowsRoot;
  using Base::leaf;
  using Base::leaf_side;
  using Base::work_of;

  /// Sets a walk's box test, which outlives the walk; reads its limit and its rotated boxes.
  void set_box_test(const TranslatedGap& bound) { set_limit(bound.limit()); }
  void set_box_test(KeptGap& bound) {
    kept_gap_ = &bound;
    set_limit(bound.limit());
  }

  /// As LeafPlanes::begin().
  FLASHBVH_NOINLINE bool begin(Side side, uint32_t node, const PackedBox* reached) {
    take(side, node);
    if (this->made_ == 0) {
      make_plane();
    }
    const uint32_t beyond = reached == nullptr ? 0 : plane_gap(*reached);
    if (beyond > sum_limit_) {
      return false;
    }
    if (this->made_ == 1) {
      make_edge();
    }
    return reached == nullptr || beyond + edge_gap(*reached) <= sum_limit_;
  }
  /// Boxes are rotated on demand.
  void take_again(Side side, uint32_t node) { take(side, node); }

  /// False only if no triangle of the leaf is within the limit of one of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) const {
    if (is_far_) {
      return is_within_far(this->node_->box, this->side_, box, this->transform_, limit_) &&
             plane_gap(box) + edge_gap(box) <= sum_limit_;
    }
    if (!is_within(this->window, box, box_limit_)) {
      return false;
    }
    const uint32_t beyond = plane_gap(box);
    return beyond <= sum_limit_ && beyond + edge_gap(box) <= sum_limit_;
  }

 protected:
  using Base::node_;

  /// Sets the box test of another walk; the limit stays.
  void keep_box_test(const TranslatedGap& /*bound*/) {}
  void keep_box_test(KeptGap& bound) { kept_gap_ = &bound; }

  /// take() and may_touch_late() replace begin() and may_touch(): each slab is made when the first
  /// box reaches it. Below a leaf the stack is deeper, so each slab is made in two calls.
  FLASHBVH_NOINLINE void take(Side side, uint32_t node) {
    if (is_taken(side, node)) {
      return;
    }
    this->node_ = (side == Side::a ? a : b).nodes + node;
    this->side_ = side;
    this->made_ = 0;
    set_box_limit();
    const PackedBox& box = this->node_->box;
    if (this->transform_.is_rotated()) {
      this->window = side == Side::a ? kept_gap_->window_of_a(box) : kept_gap_->window_of_b(box);
    } else {
      const Point& t = this->transform_.translated().offset;
      this->window = window_of(seen_translated(box, side == Side::a ? Point{-t.x, -t.y, -t.z} : t));
    }
  }
  FLASHBVH_INLINE bool may_touch_late(const PackedBox& box) {
    if (!(is_far_ ? is_within_far(node_->box, this->side_, box, this->transform_, limit_)
                  : is_within(this->window, box, box_limit_))) {
      return false;
    }
    if (__builtin_expect(this->made_ == 0, 0)) {
      make_plane_late();
    }
    const uint32_t beyond = plane_gap(box);
    if (beyond > sum_limit_) {
      return false;
    }
    if (__builtin_expect(this->made_ == 1, 0)) {
      make_edge_late();
    }
    return beyond + edge_gap(box) <= sum_limit_;
  }
  /// False only if no triangle of the leaf is within the limit of one in this box, along the leaf's
  /// own axes. Under a translation these are the other tree's axes, and nothing is tested.
  FLASHBVH_INLINE bool may_touch_along_own_axes(const PackedBox& box) const {
    if (is_far_ || !this->transform_.is_rotated()) {
      return true;
    }
    const bool is_of_a = this->side_ == Side::a;
    const PackedTriple& least = is_of_a ? kept_gap_->window_of_b(box) : kept_gap_->window_of_a(box);
    return is_within(least, node_->box, is_of_a ? limit_.limit() : limit_.longer_limit());
  }

 private:
  void set_limit(const GapLimit& limit) {
    limit_ = limit;
    sum_limit_ = limit.sum_limit();
    is_far_ = !limit.is_near();
    set_box_limit();
  }
  void set_box_limit() {
    box_limit_ = this->side_ == Side::a && this->transform_.is_rotated() ? limit_.longer_limit()
                                                                         : limit_.limit();
  }

  FLASHBVH_NOINLINE void make_plane() {
    cells_in_plane_ = this->lie_in_plane() ? see(this->plane) : 0;
  }
  FLASHBVH_NOINLINE void make_edge() {
    cells_along_edge_ = this->lie_along_edge() ? see(this->edge) : 0;
  }
  FLASHBVH_NOINLINE bool lies_in_plane() { return this->lie_in_plane(); }
  FLASHBVH_NOINLINE bool lies_along_edge() { return this->lie_along_edge(); }
  FLASHBVH_NOINLINE void make_plane_late() {
    cells_in_plane_ = lies_in_plane() ? see(this->plane) : 0;
  }
  FLASHBVH_NOINLINE void make_edge_late() {
    cells_along_edge_ = lies_along_edge() ? see(this->edge) : 0;
  }
  /// Transforms a slab from its own lattice to the other tree's. Returns cells_in_unit() of its
  /// direction.
  FLASHBVH_INLINE_FOR_SPEED uint32_t see(Slab& slab) {
    const PackedVector own = slab.direction();
    Base::see(slab, this->side_);
    return cells_in_unit(this->side_ == Side::a ? own : slab.seen_direction());
  }

  FLASHBVH_INLINE uint32_t plane_gap(const PackedBox& box) const {
    return squared(this->plane, cells_in_plane_, box);
  }
  FLASHBVH_INLINE uint32_t edge_gap(const PackedBox& box) const {
    return squared(this->edge, cells_along_edge_, box);
  }
  FLASHBVH_INLINE uint32_t squared(const Slab& slab, uint32_t cells, const PackedBox& box) const {
    return limit_.squared(static_cast<int32_t>((uint64_t{slab.gap(box)} * cells) >> 32));
  }

  KeptGap* kept_gap_ = nullptr;
  GapLimit limit_{0};
  uint32_t box_limit_ = 0;  ///< for the leaf's own box
  uint32_t sum_limit_ = 0;  ///< for its slabs
  uint32_t cells_in_plane_ = 0;
  uint32_t cells_along_edge_ = 0;
  bool is_far_ = false;  ///< last, so that a derived class's members may share its word
};

}  // namespace flashbvh::detail
