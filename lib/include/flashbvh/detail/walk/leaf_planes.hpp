// Leaf planes: a leaf's triangles reject boxes of the other tree.
//
// Once one node of a pair is a leaf, the rest below the pair is that leaf against a subtree. Three
// tests reject boxes of the subtree. The window is the leaf's own box, seen from the other tree.
// The plane is a slab along the normal of the leaf's first triangle. The edge is a slab along the
// normal, in that plane, of the triangle's longest edge. A mesh with baked slabs has the best two
// of its leaf's triangles. So no box of the subtree is rotated. The plane tests the corners of a
// leaf of the subtree before any triangle is placed; then that leaf's baked plane tests this leaf's
// corners. Any slabs give equal answers.
//
// The tests of a pair depend on the pair alone, wherever a query is cut. Only the state of the
// slabs (made, current) depends on the cuts.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/slab_simd.hpp"
#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/detail/walk/work.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

template <class Mesh>
class LeafPlanes {
 protected:
  // The members that test boxes come first, within reach of short instructions.
  PackedTriple window;
  Slab plane;
  Slab edge;

 public:
  using Tree = Mesh;
  static constexpr bool kShapes = true;
  static constexpr bool kReadsBoxTest = false;  ///< under a translation
  static constexpr bool kComparesLeaves = true;
  static constexpr bool kKnowsRoot = sizeof(typename Mesh::Index) == 2;  ///< root_ has 16 bits

  LeafPlanes(const Mesh& mesh_a, const Mesh& mesh_b, const Transform& transform)
      : a(mesh_a), b(mesh_b), transform_(transform) {}

  /// Sets a walk's box test under a rotation, which caches rotated boxes and outlives the walk.
  void set_box_test(RotatedBoxTest& bound) { rotated_ = &bound; }

  /// The work of making a leaf current and beginning below it. `node`: the leaf's node.
  FLASHBVH_INLINE uint32_t work_of(Side side, uint32_t node) const {
    const Mesh& mesh = side == Side::a ? a : b;
    return kShapeWork - 1 + mesh.triangles_in(mesh.nodes[node].leaf());
  }
  /// True if this leaf is current.
  FLASHBVH_INLINE bool is_taken(Side side, uint32_t node) const {
    return is_taken(side, (side == Side::a ? a : b).nodes + node);
  }

  /// Makes a leaf current and makes its slabs. `reached`: the other tree's box of the pair at which
  /// the walk reached the leaf, or null. False if a slab rejects `reached`.
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

  /// Called before begin() if a run resumes below the leaf, so that no pair of boxes led to it.
  /// Makes the cached boxes that this pair would have left.
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

  /// False only if no triangle of the leaf intersects a triangle of a subtree with this box.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) const {
    return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, window) &&
           may_touch_both(plane, edge, box);
  }

  /// True if all corners of the other tree's leaf at `node` lie on one side of the plane's slab, or
  /// all of this leaf's on one side of that leaf's baked plane. A rejection spends work, as no
  /// other step charges for the leaves' triangles. The edges' slabs would seldom reject more.
  FLASHBVH_INLINE bool rejects_leaf(uint32_t node, Progress& progress) const {
    return rejects_corners(node, progress) || is_rejected_by(node, progress);
  }

  /// Stores the node below which a walk of the current leaf stopped; 0 if it stopped elsewhere.
  void keep_root(uint32_t root) { root_ = static_cast<uint16_t>(root); }
  uint32_t kept_root() const { return root_; }
  Side leaf_side() const { return side_; }
  uint32_t leaf() const { return node_->leaf(); }

  const Mesh& a;
  const Mesh& b;

 protected:
  /// False only if all corners of a leaf lie on one side of a slab.
  FLASHBVH_NOINLINE static bool may_touch_corners(const Slab& slab, const Mesh& m, uint32_t leaf) {
    return slab.may_touch(m.vertices, m.triangles[m.first_triangle(leaf)].corner,
                          m.triangles[m.end_triangle(leaf)].corner);
  }
  FLASHBVH_NOINLINE void see_other(Slab& slab) const {
    see(slab, side_ == Side::a ? Side::b : Side::a);
  }
  // One after the other, for a flat stack.
  FLASHBVH_NOINLINE bool rejects_corners(uint32_t node, Progress& progress) const {
    const uint32_t leaf = other_mesh().nodes[node].leaf();
    if (may_touch_corners(plane, other_mesh(), leaf)) {
      return false;
    }
    progress.spend(kRejectedTriangleWork * other_mesh().triangles_in(leaf));
    return true;
  }
  FLASHBVH_NOINLINE bool is_rejected_by(uint32_t node, Progress& progress) const {
    const LeafSlabs* const slabs = other_mesh().slabs;
    if (slabs == nullptr) {
      return false;
    }
    Slab slab;
    slab.begin(BakedSlab::of(slabs[other_mesh().nodes[node].leaf()], 0));
    see_other(slab);
    if (may_touch_corners(slab, mesh(), node_->leaf())) {
      return false;
    }
    const uint32_t own = mesh().triangles_in(node_->leaf());
    const uint32_t tested = other_mesh().triangles_in(other_mesh().nodes[node].leaf());
    progress.spend(kOtherPlaneWork + kRejectedTriangleWork * (own > tested ? own : tested));
    return true;
  }

  const Mesh& mesh() const { return side_ == Side::a ? a : b; }
  const Mesh& other_mesh() const { return side_ == Side::a ? b : a; }

  bool is_taken(Side side, const Node<typename Mesh::Index>* node) const {
    return node == node_ && side == side_;  // A and B may be one mesh
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
      see(plane, side_);
    }
  }
  FLASHBVH_NOINLINE void make_edge() {
    if (lie_along_edge()) {
      see(edge, side_);
    }
  }

  /// These make the slabs in the leaf's own lattice, the plane's first. False if there is no
  /// direction: the slab is then the whole space. `edge` holds the plane's normal in between.
  FLASHBVH_INLINE_FOR_SPEED bool lie_in_plane() {
    made_ = 1;
    const Mesh& m = mesh();
    if (m.slabs != nullptr) {
      plane.begin(BakedSlab::of(m.slabs[node_->leaf()], 0));
      return true;
    }
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
    if (m.slabs != nullptr) {
      edge.begin(BakedSlab::of(m.slabs[node_->leaf()], 1));
      return true;
    }
    const uint32_t first = m.first_triangle(node_->leaf());
    const PackedTriangle t = triangle(m, first);
    PackedVector direction;
    const bool good = t.edge_direction(edge.direction(), direction);
    return hold(edge, good, direction, t, first);
  }
  /// Makes a slab that holds all of the leaf's triangles. `t`: the first triangle.
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
  /// Transforms a slab of side `of` to the other tree's lattice.
  FLASHBVH_INLINE_FOR_SPEED void see(Slab& slab, Side of) const {
    if (transform_.is_rotated()) {
      slab.rotate(transform_, of);
    } else {
      slab.translate(transform_.translated().offset, of);
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
  uint8_t made_ = 0;  ///< number of slabs
  uint16_t root_ = 0;
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
