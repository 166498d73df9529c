// Boxes of a tree whose vertices moved, from the leaves up, in one pass.
//
// In both layouts a node lies before its subtrees, so backwards in the array children come before
// their parents, and the box of the child that lies right after its parent is at hand when the
// parent's turn comes. Leaves and their triangles come in the array's order, too, so nothing is
// looked up.
#ifndef FLASHBVH_DETAIL_REFIT_HPP
#define FLASHBVH_DETAIL_REFIT_HPP

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/fraction.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/packed.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// Half by half the larger of the two.
inline uint32_t larger_halves(uint32_t u, uint32_t v) {
  return subtract_halves(u, v) + v;
}
inline void add_box(PackedBox& box, const PackedBox& other) {
  box.upper_xy = larger_halves(box.upper_xy, other.upper_xy);
  box.lower_xy = larger_halves(box.lower_xy, other.lower_xy);
  box.z = larger_halves(box.z, other.z);
}

/// Set in a bound beyond the lattice, and then in the same bound of every box that holds it.
constexpr uint32_t kBeyondLattice = 0x80008000;
constexpr bool is_in_lattice(const PackedBox& box) {
  return ((box.upper_xy | box.lower_xy | box.z) & kBeyondLattice) == 0;
}
constexpr bool is_in_lattice(const Vertex& v) {
  const auto fits = [](int32_t at) { return -kMaxCoordinate <= at && at <= kMaxCoordinate; };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)

/// Of triangles of one mesh. What is the same for all is kept out of the compiler's sight, which
/// would make it anew for each.
class VertexBoxes {
 public:
  explicit VertexBoxes(const Vertex* vertices)
      : xy_(reinterpret_cast<const char*>(vertices)), z_(xy_ + offsetof(Vertex, z)) {
    __asm__("" : "+r"(z_), "+r"(negative_high_), "+r"(raise_));
  }

  /// Coordinates are raised as bounds are; one beyond the lattice wraps to 2^15 or more.
  template <class Index>
  FLASHBVH_INLINE PackedBox box_of(const Corners<Index>& triangle) const {
    const uint32_t a = triangle.corner[0] * kSize;
    const uint32_t b = triangle.corner[1] * kSize;
    const uint32_t c = triangle.corner[2] * kSize;
    const uint32_t xy_a = xy(a);
    const uint32_t xy_b = xy(b);
    const uint32_t xy_c = xy(c);
    const uint32_t over = __uqsub16(xy_a, xy_b);
    const uint32_t least = xy_a - over;
    // Halves stay in themselves where nothing is beyond the lattice.
    return {larger_halves(over + xy_b, xy_c), 2 * kRaise - (least - __uqsub16(least, xy_c)),
            larger_halves(larger_halves(z(a), z(b)), z(c))};
  }

 private:
  static constexpr uint32_t kSize = sizeof(Vertex);
  static constexpr uint32_t kRaise = kBoundBias * 0x10001u;

  FLASHBVH_INLINE uint32_t xy(uint32_t at) const {
    uint32_t word;
    memcpy(&word, xy_ + at, sizeof word);
    return __uadd16(word, raise_);
  }
  /// z + bias low, bias - z high: one product and a sum.
  FLASHBVH_INLINE uint32_t z(uint32_t at) const {
    int16_t half;
    memcpy(&half, z_ + at, sizeof half);
    return static_cast<uint32_t>(half) * negative_high_ + raise_;
  }

  const char* xy_;
  const char* z_;
  uint32_t negative_high_ = 0xFFFF0001;
  uint32_t raise_ = kRaise;
};

#else

/// Of triangles of one mesh, with plain numbers.
class VertexBoxes {
 public:
  explicit VertexBoxes(const Vertex* vertices) : vertices_(vertices) {}

  template <class Index>
  PackedBox box_of(const Corners<Index>& triangle) const {
    const Vertex& a = vertices_[triangle.corner[0]];
    const Vertex& b = vertices_[triangle.corner[1]];
    const Vertex& c = vertices_[triangle.corner[2]];
    return {join_halves(most(a.x, b.x, c.x), most(a.y, b.y, c.y)),
            join_halves(most(-a.x, -b.x, -c.x), most(-a.y, -b.y, -c.y)),
            join_halves(most(a.z, b.z, c.z), most(-a.z, -b.z, -c.z))};
  }

 private:
  static uint16_t most(int32_t u, int32_t v, int32_t w) {
    const int32_t larger = u < v ? v : u;
    return static_cast<uint16_t>(pack_bound(larger < w ? w : larger));
  }

  const Vertex* vertices_;
};

#endif

/// No shorter than any edge in the box: its diagonal.
inline uint16_t longest_edge_in(const PackedBox& box) {
  const int64_t x = extent_x(box);
  const int64_t y = extent_y(box);
  const int64_t z = extent_z(box);
  return static_cast<uint16_t>(square_root(widened(x * x + y * y + z * z)) + 1);
}

/// Where a refit is: the next node's box is made of what lies after it.
template <class Mesh>
struct RefitPlace {
  const Corners<typename Mesh::Index>* triangles;  ///< after those of the leaves to come
  PackedBox box;                                   ///< of the node after, which came before
};

/// The boxes of `nodes` from `end` down to `begin`. `kOne`: one triangle in each leaf.
template <bool kOne, class Mesh>
FLASHBVH_NOINLINE void refit_nodes(const Mesh& mesh, Node<typename Mesh::Index>* nodes,
                                   uint32_t begin, uint32_t end, RefitPlace<Mesh>& place) {
  using NodeType = Node<typename Mesh::Index>;
  const VertexBoxes boxes(mesh.vertices);
  const auto* triangle = place.triangles;
  PackedBox box = place.box;
  NodeType* node = nodes + end;
  NodeType* const first = nodes + begin;
  do {
    --node;
    if (node->is_leaf()) {
      box = boxes.box_of(*--triangle);
      if constexpr (!kOne) {
        const auto* const first_of_leaf = mesh.triangles + mesh.leaf_offsets[node->leaf()];
        while (triangle != first_of_leaf) {
          add_box(box, boxes.box_of(*--triangle));
        }
      }
    } else {
      const NodeType* const end_of_children =
          Mesh::kLayout == Layout::post_indexed ? node + 1 : nodes + node->link;
      for (const NodeType* child = nodes + node[1].link; child != end_of_children;
           child = nodes + child->link) {
        add_box(box, child->box);
      }
    }
    node->box = box;
  } while (node != first);
  place = {triangle, box};
}

}  // namespace flashbvh::detail

#endif
