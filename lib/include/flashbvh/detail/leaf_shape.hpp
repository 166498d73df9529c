// A leaf as a shape: what its triangles reject of the other tree's boxes.
//
// Once one node of a pair is a leaf, all that is left below the pair is that leaf against a
// subtree. The leaf's own box, seen from the other tree, is a window; then come the plane of its
// first triangle, and in that plane the normal of the triangle's longest edge. So no box of the
// subtree is rotated. The baker puts the triangle first whose slabs reject most; any other order
// gives the same answers.
//
// What is tested of a pair follows from the pair alone, however a query was cut: only whether a
// slab is made or at hand does not.
#ifndef FLASHBVH_DETAIL_LEAF_SHAPE_HPP
#define FLASHBVH_DETAIL_LEAF_SHAPE_HPP

#include <stdint.h>

#include "flashbvh/detail/box_rotated.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/packed.hpp"
#include "flashbvh/detail/slab.hpp"

namespace flashbvh::detail {

template <class Mesh>
class LeafShapes {
 public:
  using Tree = Mesh;
  static constexpr bool kShapes = true;

  /// `rotated`: the bound of a walk under a rotation, whose rotated boxes are at hand; null under a
  /// translation.
  LeafShapes(const Mesh& mesh_a, const Mesh& mesh_b, const Transform& transform,
             RotatedBound* rotated)
      : a(mesh_a), b(mesh_b), transform_(transform), rotated_(rotated) {}

  /// Takes a leaf, by its node, as the shape for boxes of the other tree.
  FLASHBVH_NOINLINE void begin(Side side, uint32_t node) {
    const Node<typename Mesh::Index>* const at = (side == Side::a ? a : b).nodes + node;
    if (at == node_ && side == side_) {  // one mesh may be both
      return;
    }
    node_ = at;
    side_ = side;
    made_ = 0;
    if (rotated_ != nullptr) {
      window_ = side == Side::a ? rotated_->window_of_a(at->box) : rotated_->window_of_b(at->box);
    } else {
      const TranslatedBound& bound = transform_.translated().bound;
      window_ = side == Side::a ? bound.window_of_a(at->box) : bound.window_of_b(at->box);
    }
  }

  /// False only if no triangle of the leaf intersects one of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) {
    return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window_) && slabs_touch(box);
  }
  /// The same of a box that the window has passed.
  FLASHBVH_INLINE bool slabs_touch(const PackedBox& box) {
    if (made_ == 0) {
      make_slab();
    }
    if (!plane_.may_touch(box)) {
      return false;
    }
    if (made_ == 1) {
      make_slab();
    }
    return edge_.may_touch(box);
  }

  const Mesh& a;
  const Mesh& b;

 private:
  const Mesh& mesh() const { return side_ == Side::a ? a : b; }

  /// The plane's first, then the edge's. What has no direction is the whole space.
  FLASHBVH_NOINLINE void make_slab() {
    const PackedTriangle first = triangle(mesh().first_triangle(node_->leaf()));
    Slab& slab = made_ == 0 ? plane_ : edge_;
    PackedVector direction;
    const bool good = made_ == 0 ? first.plane_direction(direction)
                                 : first.edge_direction(normal_, direction);
    if (made_ == 0) {
      normal_ = direction;
    }
    ++made_;
    if (good) {
      set(slab, direction, first);
    } else {
      slab.set_all();
    }
  }

  FLASHBVH_INLINE PackedTriangle triangle(uint32_t position) const {
    const Mesh& m = mesh();
    const auto& corner = m.triangles[position].corner;
    return {PackedVector::of(m.vertices[corner[0]]), PackedVector::of(m.vertices[corner[1]]),
            PackedVector::of(m.vertices[corner[2]])};
  }

  FLASHBVH_INLINE void set(Slab& slab, const PackedVector& direction, const PackedTriangle& first) {
    const int32_t at = dot(direction, first.p);
    Extent extent = {at, at};
    extent.add(dot(direction, first.q));
    extent.add(dot(direction, first.r));
    slab.begin(direction, extent);
    if (mesh().leaf_offsets != nullptr) {
      add_others(slab);
    }
    if (rotated_ != nullptr) {
      slab.rotate(transform_.rotated(), side_, reach(b.nodes[0].box));
    } else {
      slab.translate(transform_.translated().offset, side_);
    }
  }

  /// The leaf's triangles after the first.
  FLASHBVH_NOINLINE void add_others(Slab& slab) const {
    const Mesh& m = mesh();
    const PackedVector direction = slab.direction();
    Extent extent = slab.extent();
    const uint32_t end = m.end_triangle(node_->leaf());
    for (uint32_t i = m.first_triangle(node_->leaf()) + 1; i < end; ++i) {
      triangle(i).extend(extent, direction);
    }
    slab.begin(direction, extent);
  }

  const Transform& transform_;
  RotatedBound* rotated_;
  const Node<typename Mesh::Index>* node_ = nullptr;  ///< the leaf
  Side side_ = Side::none;
  uint8_t made_ = 0;  ///< slabs
  PackedTriple window_;
  Slab plane_;
  Slab edge_;
  PackedVector normal_;
};

}  // namespace flashbvh::detail

#endif
