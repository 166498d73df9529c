// A leaf as a shape in questions about distance: how far its triangles are from the other tree's
// boxes at least (leaf_shape.hpp has the same of intersection).
//
// The leaf's own box, seen from the other tree, bounds the distance along that tree's axes; its
// plane and, in it, the normal of its longest edge bound it along two more directions, which are
// nearly orthogonal: squared gaps along both add up, but for one part in 2^9. That holds what is
// between two rounded directions: each is off by less than sqrt(3) of 2^12, and by as much again
// once rotated.
#ifndef FLASHBVH_DETAIL_NEAR_SHAPE_HPP
#define FLASHBVH_DETAIL_NEAR_SHAPE_HPP

#include <stdint.h>

#include "flashbvh/detail/gap.hpp"
#include "flashbvh/detail/leaf_shape.hpp"

namespace flashbvh::detail {

/// A slab that tells how far off boxes are. 24 bytes.
class NearSlab {
 public:
  Slab slab;

  /// To be asked; `direction`: along which distances are true, in A's lattice.
  void set_length(const PackedVector& direction);
  /// The whole space.
  void set_all() {
    slab.set_all();
    cells_ = 0;
  }
  /// How far off a box is, in cells, rounded down.
  FLASHBVH_INLINE int32_t gap(const PackedBox& box) const {
    return static_cast<int32_t>((uint64_t{slab.gap(box)} * cells_) >> 32);
  }

 private:
  uint32_t cells_ = 0;  ///< in a unit of the direction, times 2^32, rounded down
};

template <class Mesh>
class NearShapes {
 public:
  using Tree = Mesh;
  static constexpr bool kShapes = true;
  static constexpr bool kAsksBound = true;

  NearShapes(const Mesh& mesh_a, const Mesh& mesh_b, const Transform& transform)
      : a(mesh_a), b(mesh_b), transform_(transform) {}

  /// The bound of a walk, while it lasts: its limit is asked for, and its rotated boxes.
  void set_bound(const TranslatedGap& bound) { limit_ = bound.limit(); }
  void set_bound(RotatedGap& bound) {
    limit_ = bound.limit();
    rotated_ = &bound;
  }

  FLASHBVH_INLINE uint32_t work_of(Side side, uint32_t node) const {
    const Mesh& mesh = side == Side::a ? a : b;
    return kShapeWork - 1 + mesh.triangles_in(mesh.nodes[node].leaf());
  }
  FLASHBVH_INLINE bool is_taken(Side side, uint32_t node) const {
    return node_ == (side == Side::a ? a : b).nodes + node && side == side_;
  }

  /// As LeafShapes::begin().
  FLASHBVH_NOINLINE bool begin(Side side, uint32_t node, const PackedBox* reached) {
    take(side, node);
    if (made_ == 0) {
      make(plane_);
    }
    const uint32_t beyond = reached == nullptr ? 0 : limit_.squared(plane_.gap(*reached));
    if (beyond > limit_.sum_limit()) {
      return false;
    }
    if (made_ == 1) {
      make(edge_);
    }
    return reached == nullptr || beyond + limit_.squared(edge_.gap(*reached)) <= limit_.sum_limit();
  }
  /// Boxes are rotated where they are needed.
  void take_again(Side side, uint32_t node) { take(side, node); }

  /// False only if no triangle of the leaf is near enough to one of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) const {
    return squared_gap(seen_, box, limit_) <=
               (side_ == Side::a && rotated_ != nullptr ? limit_.longer_limit() : limit_.limit()) &&
           limit_.squared(plane_.gap(box)) + limit_.squared(edge_.gap(box)) <= limit_.sum_limit();
  }

  const Mesh& a;
  const Mesh& b;

 private:
  FLASHBVH_NOINLINE void take(Side side, uint32_t node) {
    if (is_taken(side, node)) {
      return;
    }
    node_ = (side == Side::a ? a : b).nodes + node;
    side_ = side;
    made_ = 0;
    if (rotated_ != nullptr) {
      seen_ = side == Side::a ? rotated_->seen_of_a(node_->box) : rotated_->seen_of_b(node_->box);
    } else {
      const Point& t = transform_.translated().offset;
      seen_ = side == Side::a ? seen_translated(node_->box, {-t.x, -t.y, -t.z})
                              : seen_translated(node_->box, t);
    }
  }

  /// The plane's first, then the edge's.
  FLASHBVH_NOINLINE void make(NearSlab& near) {
    const Mesh& mesh = side_ == Side::a ? a : b;
    const LeafTriangles<Mesh> triangles = {mesh, node_->leaf()};
    if (!(made_++ == 0 ? triangles.lie_in_plane(plane_.slab, edge_.slab)
                       : triangles.lie_along_edge(edge_.slab))) {
      near.set_all();
      return;
    }
    if (mesh.leaf_offsets != nullptr) {
      triangles.add_others(near.slab);
    }
    const PackedVector own = near.slab.direction();
    if (rotated_ == nullptr) {
      near.slab.translate(transform_.translated().offset, side_);
      near.set_length(own);
    } else {
      near.slab.rotate(transform_, side_);
      near.set_length(side_ == Side::a ? own : near.slab.seen_direction());
    }
  }

  const Transform& transform_;
  RotatedGap* rotated_ = nullptr;
  const Node<typename Mesh::Index>* node_ = nullptr;  ///< the leaf
  Side side_ = Side::none;
  uint8_t made_ = 0;  ///< slabs
  GapLimit limit_{0};
  SeenBox seen_{};
  NearSlab plane_;
  NearSlab edge_;
};

}  // namespace flashbvh::detail

#endif
