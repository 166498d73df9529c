// A leaf as a shape: what its triangles reject of the other tree's boxes.
//
// Once one node of a pair is a leaf, all that is left below the pair is that leaf against a
// subtree. The leaf's own box, seen from the other tree, is a window; then come the plane of its
// first triangle, and in that plane the normal of the triangle's longest edge. So no box of the
// subtree is rotated. A leaf of the subtree is then held against the plane by its corners, before
// any triangle is placed. The baker puts the triangle first whose slabs reject most; any other
// order gives the same answers.
//
// What is tested of a pair follows from the pair alone, however a query was cut: only whether a
// slab is made or current does not.
#ifndef FLASHBVH_DETAIL_WALK_LEAF_PLANES_HPP
#define FLASHBVH_DETAIL_WALK_LEAF_PLANES_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/slab_simd.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"

namespace flashbvh::detail {

template <class Mesh>
class LeafPlanes {
 protected:
  // What the leaf holds against boxes: at the beginning, within reach of short instructions.
  PackedTriple window;
  Slab plane;
  Slab edge;

 public:
  using Tree = Mesh;
  static constexpr bool kShapes = true;
  static constexpr bool kReadsBoxTest = false;  ///< of a translation
  static constexpr bool kComparesLeaves = true;
  static constexpr bool kKnowsRoot = sizeof(typename Mesh::Index) == 2;  ///< there is room

  LeafPlanes(const Mesh& mesh_a, const Mesh& mesh_b, const Transform& transform)
      : a(mesh_a), b(mesh_b), transform_(transform) {}

  /// The bound of a walk under a rotation, while it lasts; it keeps its rotated boxes.
  void set_box_test(RotatedBoxTest& bound) { rotated_ = &bound; }

  /// What it is in work to take a leaf, by its node, and to begin below it.
  FLASHBVH_INLINE uint32_t work_of(Side side, uint32_t node) const {
    const Mesh& mesh = side == Side::a ? a : b;
    return kShapeWork - 1 + mesh.triangles_in(mesh.nodes[node].leaf());
  }
  /// Whether it is current.
  FLASHBVH_INLINE bool is_taken(Side side, uint32_t node) const {
    return is_taken(side, (side == Side::a ? a : b).nodes + node);
  }

  /// Takes a leaf, by its node, as the shape for boxes of the other tree. `reached`: the box of
  /// that tree with which the leaf was reached, or null; false if a slab rejects it.
  FLASHBVH_INLINE_FOR_SPEED bool begin(Side side, uint32_t node, const PackedBox* reached) {
    take(side, (side == Side::a ? a : b).nodes + node);
    if (made_ == 0) {
      make_plane();
    }
    if (reached != nullptr && !plane.may_touch(*reached)) {
      return false;
    }
    if (made_ == 1) {
      make_edge();
    }
    return reached == nullptr || edge.may_touch(*reached);
  }

  /// Before begin() of a leaf below which a run goes on, so that no pair of boxes led to it: what
  /// that pair would have left is made.
  FLASHBVH_NOINLINE void take_again(Side side, uint32_t node) {
    const PackedBox& box = (side == Side::a ? a : b).nodes[node].box;
    if (rotated_ != nullptr) {
      if (side == Side::a) {
        rotated_->keep_a(box);
      } else {
        rotated_->keep_b(box);
      }
    }
    take(side, (side == Side::a ? a : b).nodes + node);
    const PackedBox& root = (side == Side::a ? b : a).nodes[0].box;
    if (!halves_reach({{root.upper_xy, root.lower_xy, root.z}}, window)) {
      // No box will pass the window, and the trees may be too far apart for sums of 32 bits.
      plane.set_all();
      edge.set_all();
      made_ = 2;
    }
  }

  /// False only if no triangle of the leaf intersects one of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) const {
    return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window) &&
           may_touch_both(plane, edge, box);
  }

  /// Whether the plane's slab has all corners of the other tree's leaf, by its node, on one side;
  /// that costs work then, as its triangles are not paid for. The edge's slab would seldom add to
  /// it.
  FLASHBVH_NOINLINE bool rejects_leaf(uint32_t node, Progress& progress) const {
    const Mesh& m = other_mesh();
    const uint32_t leaf = m.nodes[node].leaf();
    const uint32_t first = m.first_triangle(leaf);
    const uint32_t after = m.end_triangle(leaf);
    const auto* const corner = m.triangles[first].corner;
    const auto* const end = m.triangles[after].corner;
    if (plane.may_touch(m.vertices, corner, end)) {
      return false;
    }
    progress.spend(kRejectedTriangleWork * (after - first));
    return true;
  }

  /// Of the current leaf, below which node a walk stopped; 0 if it stopped elsewhere.
  void keep_root(uint32_t root) { root_ = static_cast<uint16_t>(root); }
  uint32_t kept_root() const { return root_; }
  Side leaf_side() const { return side_; }
  uint32_t leaf() const { return node_->leaf(); }

  const Mesh& a;
  const Mesh& b;

 protected:
  const Mesh& mesh() const { return side_ == Side::a ? a : b; }
  const Mesh& other_mesh() const { return side_ == Side::a ? b : a; }

  bool is_taken(Side side, const Node<typename Mesh::Index>* node) const {
    return node == node_ && side == side_;  // one mesh may be both
  }
  FLASHBVH_NOINLINE void take(Side side, const Node<typename Mesh::Index>* node) {
    if (is_taken(side, node)) {
      return;
    }
    node_ = node;
    side_ = side;
    made_ = 0;
    const PackedBox& box = node->box;
    if (rotated_ != nullptr) {
      window = side == Side::a ? rotated_->window_of_a(box) : rotated_->window_of_b(box);
    } else {
      const TranslatedBoxTest& bound = transform_.translated().bound;
      window = side == Side::a ? bound.window_of_a(box) : bound.window_of_b(box);
    }
  }

  FLASHBVH_NOINLINE void make_plane() {
    if (lie_in_plane()) {
      see(plane);
    }
  }
  FLASHBVH_NOINLINE void make_edge() {
    if (lie_along_edge()) {
      see(edge);
    }
  }

  /// As slabs lie in their own lattice, the plane's first; false, and the whole space, if there is
  /// no direction. The plane's normal waits where the edge's slab will be.
  FLASHBVH_INLINE_FOR_SPEED bool lie_in_plane() {
    made_ = 1;
    const Mesh& m = mesh();
    const uint32_t first = m.first_triangle(node_->leaf());
    const PackedTriangle t = triangle(m, first);
    PackedVector normal;
    const bool good = t.plane_direction(normal);
    edge.keep_direction(normal);
    return hold(plane, good, normal, t, first);
  }
  FLASHBVH_INLINE_FOR_SPEED bool lie_along_edge() {
    made_ = 2;
    const Mesh& m = mesh();
    const uint32_t first = m.first_triangle(node_->leaf());
    const PackedTriangle t = triangle(m, first);
    PackedVector direction;
    const bool good = t.edge_direction(edge.direction(), direction);
    return hold(edge, good, direction, t, first);
  }
  /// All of the leaf's triangles; `t`: the first.
  FLASHBVH_INLINE_FOR_SPEED bool hold(Slab& slab, bool good, const PackedVector& direction,
                                      const PackedTriangle& t, uint32_t first) {
    if (!good) {
      slab.set_all();
      return false;
    }
    const Mesh& m = mesh();
    Extent extent = t.extent(direction);
    if (m.leaf_offsets != nullptr) {
      const uint32_t end = m.end_triangle(node_->leaf());
      for (uint32_t i = first + 1; i < end; ++i) {
        extent.add(triangle(m, i).extent(direction));
      }
    }
    slab.begin(direction, extent);
    return true;
  }
  /// As the other tree sees it.
  FLASHBVH_INLINE_FOR_SPEED void see(Slab& slab) const {
    if (transform_.is_rotated()) {
      slab.rotate(transform_, side_);
    } else {
      slab.translate(transform_.translated().offset, side_);
    }
  }

  FLASHBVH_INLINE_FOR_SPEED static PackedTriangle triangle(const Mesh& m, uint32_t position) {
    const auto& corner = m.triangles[position].corner;
    return {PackedVector::of(m.vertices[corner[0]]), PackedVector::of(m.vertices[corner[1]]),
            PackedVector::of(m.vertices[corner[2]])};
  }

  const Transform& transform_;
  RotatedBoxTest* rotated_ = nullptr;
  const Node<typename Mesh::Index>* node_ = nullptr;  ///< the leaf
  Side side_ = Side::none;
  uint8_t made_ = 0;  ///< slabs
  uint16_t root_ = 0;
};

}  // namespace flashbvh::detail

#endif
