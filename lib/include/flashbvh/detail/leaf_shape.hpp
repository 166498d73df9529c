// A leaf as a shape: what its triangles reject of the other tree's boxes.
//
// Once one node of a pair is a leaf, all that is left below the pair is that leaf against a
// subtree. The leaf's own box, seen from the other tree, is a window that rejects most; then the
// plane of its first triangle, then the normal of that triangle's first edge in its plane. So no box of the subtree
// is rotated. The baker puts first the triangle and the edge that reject most; any other order
// gives the same answers.
//
// What is tested of a pair follows from the pair alone, however a query was cut: only whether a
// slab is made or at hand does not.
#ifndef FLASHBVH_DETAIL_LEAF_SHAPE_HPP
#define FLASHBVH_DETAIL_LEAF_SHAPE_HPP

#include <stdint.h>

#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/packed.hpp"
#include "flashbvh/detail/slab.hpp"

namespace flashbvh::detail {

template <class Mesh>
class LeafShapes {
 public:
  LeafShapes(const Mesh& a, const Mesh& b, const Transform& transform)
      : a_(a), b_(b), transform_(transform) {}

  /// The shape of a leaf of A, by its node, for boxes of B; and the other way round.
  template <class Bound>
  LeafShapes& of_a(const Bound& bound, uint32_t node) {
    window_ = bound.window_of_a(a_.nodes[node].box);
    return of(Side::a, a_, node);
  }
  template <class Bound>
  LeafShapes& of_b(const Bound& bound, uint32_t node) {
    window_ = bound.window_of_b(b_.nodes[node].box);
    return of(Side::b, b_, node);
  }

  /// False only if no triangle of the leaf intersects one of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) {
    return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window_) && slabs_touch(box);
  }
  /// The same of a box that the window has passed.
  FLASHBVH_INLINE bool slabs_touch(const PackedBox& box) {
    if (made_ == 0) {
      make_plane();
    }
    if (!plane_.may_touch(box)) {
      return false;
    }
    if (made_ == 1) {
      make_edge();
    }
    return edge_.may_touch(box);
  }

 private:
  LeafShapes& of(Side side, const Mesh& mesh, uint32_t node) {
    const Node<typename Mesh::Index>* const at = mesh.nodes + node;
    if (at != node_) {
      node_ = at;
      side_ = side;
      made_ = 0;
    }
    return *this;
  }

  const Mesh& mesh() const { return side_ == Side::a ? a_ : b_; }

  FLASHBVH_NOINLINE void make_plane() {
    const Vertex* corner[3];
    get_first(corner);
    if (plane_direction(*corner[0], *corner[1], *corner[2], normal_)) {
      set(plane_, normal_);
      made_ = 1;
    } else {
      plane_.set_all();
      edge_.set_all();
      made_ = 2;
    }
  }
  FLASHBVH_NOINLINE void make_edge() {
    const Vertex* corner[3];
    get_first(corner);
    Direction direction;
    if (edge_direction(*corner[0], *corner[1], normal_, direction)) {
      set(edge_, direction);
    } else {
      edge_.set_all();
    }
    made_ = 2;
  }

  void get_first(const Vertex* (&corner)[3]) const {
    const Mesh& m = mesh();
    const auto& triangle = m.triangles[m.first_triangle(node_->leaf())];
    for (int i = 0; i < 3; ++i) {
      corner[i] = m.vertices + triangle.corner[i];
    }
  }

  void set(Slab& slab, const Direction& direction) {
    if (reach_b_ == 0) {
      reach_b_ = reach(b_.nodes[0].box);
    }
    const Mesh& m = mesh();
    const uint32_t leaf = node_->leaf();
    Extent extent = {INT32_MAX, INT32_MIN};
    for (uint32_t i = m.first_triangle(leaf); i < m.end_triangle(leaf); ++i) {
      for (const auto corner : m.triangles[i].corner) {
        extent.add(along(direction, m.vertices[corner]));
      }
    }
    slab.set(direction, extent, transform_, side_, reach_b_);
  }

  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  const Node<typename Mesh::Index>* node_ = nullptr;  ///< the leaf
  int32_t reach_b_ = 0;
  Side side_ = Side::none;
  uint8_t made_ = 0;  ///< slabs
  PackedTriple window_;
  Slab plane_;
  Slab edge_;
  Direction normal_;
};

}  // namespace flashbvh::detail

#endif
