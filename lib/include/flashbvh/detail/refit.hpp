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
FLASHBVH_INLINE inline void add_box(PackedBox& box, PackedBox other) {
  box.upper_xy = larger_halves(box.upper_xy, other.upper_xy);
  box.lower_xy = larger_halves(box.lower_xy, other.lower_xy);
  box.z = larger_halves(box.z, other.z);
}

#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)
/// What follows is not begun before `value` is there: there are registers for one after the other.
FLASHBVH_INLINE inline void finish(uint32_t& value) {
  __asm__ volatile("" : "+r"(value) : : "memory");
}
FLASHBVH_INLINE inline void add_stored(PackedBox& box, const PackedBox& other) {
  uint32_t upper_xy;
  uint32_t lower_xy;
  __asm__("ldrd %0, %1, [%2]" : "=&r"(upper_xy), "=r"(lower_xy) : "r"(&other), "m"(other));
  box.upper_xy = larger_halves(box.upper_xy, upper_xy);
  box.lower_xy = larger_halves(box.lower_xy, lower_xy);
  finish(box.lower_xy);
  box.z = larger_halves(box.z, other.z);
}
#else
inline void add_stored(PackedBox& box, const PackedBox& other) {
  add_box(box, other);
}
#endif

/// Set in a bound beyond the lattice, and then in the same bound of every box that holds it.
constexpr uint32_t kBeyondLattice = 0x80008000;
constexpr bool is_in_lattice(const PackedBox& box) {
  return ((box.upper_xy | box.lower_xy | box.z) & kBeyondLattice) == 0;
}
constexpr bool is_in_lattice(const Vertex& v) {
  const auto fits = [](int32_t at) { return -kMaxCoordinate <= at && at <= kMaxCoordinate; };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

/// Of vertices by their numbers, three or four at once.
#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)

/// Halves are compared with their signs, and raised once a box; one beyond the lattice wraps to
/// 2^15 or more. What is the same for all is kept out of the compiler's sight, which would make it
/// anew for each.
class VertexBoxes {
 public:
  explicit VertexBoxes(const Vertex* vertices)
      : xy_(reinterpret_cast<const char*>(vertices)), z_(xy_ + offsetof(Vertex, z)) {
    __asm__("" : "+r"(z_), "+r"(negative_high_), "+r"(raise_));
  }

  FLASHBVH_INLINE PackedBox box_of(uint32_t u, uint32_t v, uint32_t w) const {
    uint32_t of_z = larger_halves(larger_halves(z(u), z(v)), z(w));
    finish(of_z);
    const uint32_t last = xy(w);
    return packed(joined(pair(u, v), {last, last}), of_z);
  }
  FLASHBVH_INLINE PackedBox box_of(uint32_t u, uint32_t v, uint32_t w, uint32_t t) const {
    uint32_t of_z = larger_halves(larger_halves(z(u), z(v)), larger_halves(z(w), z(t)));
    finish(of_z);
    return packed(joined(pair(u, v), pair(w, t)), of_z);
  }

 private:
  static constexpr uint32_t kRaise = kBoundBias * 0x10001u;

  /// Of x and y, half by half.
  struct Span {
    uint32_t most;
    uint32_t least;
  };

  FLASHBVH_INLINE uint32_t xy(uint32_t vertex) const {
    uint32_t word;
    __builtin_memcpy(&word, xy_ + vertex * sizeof(Vertex), sizeof word);
    return word;
  }
  /// z + bias low, bias - z high: one product and a sum.
  FLASHBVH_INLINE uint32_t z(uint32_t vertex) const {
    int16_t half;
    __builtin_memcpy(&half, z_ + vertex * sizeof(Vertex), sizeof half);
    return static_cast<uint32_t>(half) * negative_high_ + raise_;
  }
  FLASHBVH_INLINE Span pair(uint32_t vertex_u, uint32_t vertex_v) const {
    const uint32_t u = xy(vertex_u);
    const uint32_t v = xy(vertex_v);
    Span span;
    __asm__("ssub16 %0, %2, %3\n\tsel %0, %2, %3\n\tsel %1, %3, %2"
            : "=&r"(span.most), "=r"(span.least)
            : "r"(u), "r"(v));
    return span;
  }
  FLASHBVH_INLINE static Span joined(const Span& p, const Span& q) {
    Span span;
    __asm__("ssub16 %0, %1, %2\n\tsel %0, %1, %2" : "=&r"(span.most) : "r"(p.most), "r"(q.most));
    __asm__("ssub16 %0, %1, %2\n\tsel %0, %2, %1" : "=&r"(span.least) : "r"(p.least), "r"(q.least));
    return span;
  }
  FLASHBVH_INLINE PackedBox packed(const Span& span, uint32_t of_z) const {
    return {__uadd16(span.most, raise_), __usub16(raise_, span.least), of_z};
  }

  const char* xy_;
  const char* z_;
  uint32_t negative_high_ = 0xFFFF0001;
  uint32_t raise_ = kRaise;
};

#else

class VertexBoxes {
 public:
  explicit VertexBoxes(const Vertex* vertices) : vertices_(vertices) {}

  template <class... Numbers>
  FLASHBVH_INLINE PackedBox box_of(uint32_t first, Numbers... others) const {
    const Vertex& v = vertices_[first];
    Box box = {v, v};
    (add(box, vertices_[others]), ...);
    return {join_halves(half(box.upper.x), half(box.upper.y)),
            join_halves(half(-box.lower.x), half(-box.lower.y)),
            join_halves(half(box.upper.z), half(-box.lower.z))};
  }

 private:
  static uint16_t half(int32_t bound) { return static_cast<uint16_t>(pack_bound(bound)); }
  FLASHBVH_INLINE static void add(Box& box, const Vertex& v) {
    add(box.lower.x, box.upper.x, v.x);
    add(box.lower.y, box.upper.y, v.y);
    add(box.lower.z, box.upper.z, v.z);
  }
  FLASHBVH_INLINE static void add(int16_t& least, int16_t& most, int16_t at) {
    least = at < least ? at : least;
    most = at > most ? at : most;
  }

  const Vertex* vertices_;
};

#endif

/// Whether the last two corners of `u` are those of `v` in the other order: a shared edge, as
/// `flashbvh bake --deformable` turns the triangles of a leaf.
template <class Index>
FLASHBVH_INLINE inline bool is_quad(const Corners<Index>& u, const Corners<Index>& v) {
  if constexpr (sizeof(Index) == sizeof(uint16_t)) {
    uint32_t edge_of_u;
    uint32_t edge_of_v;
    __builtin_memcpy(&edge_of_u, &u.corner[1], sizeof edge_of_u);
    __builtin_memcpy(&edge_of_v, &v.corner[1], sizeof edge_of_v);
    return edge_of_u == swap_halves(edge_of_v);
  } else {
    return u.corner[1] == v.corner[2] && u.corner[2] == v.corner[1];
  }
}

/// No shorter than any edge in the box: its diagonal.
inline uint16_t longest_edge_in(const PackedBox& box) {
  const int64_t x = extent_x(box);
  const int64_t y = extent_y(box);
  const int64_t z = extent_z(box);
  return static_cast<uint16_t>(square_root(widened(x * x + y * y + z * z)) + 1);
}

/// Where a refit is: the next node's box is made of what lies after it.
struct RefitPlace {
  uint32_t leaf;  ///< after the leaves to come
  PackedBox box;  ///< of the node after, which came before
};

/// Leaves' boxes, from the last one on. `kOne`: one triangle in each.
template <bool kOne, class Mesh>
class LeafBoxes {
 public:
  using Index = typename Mesh::Index;

  LeafBoxes(const Mesh& mesh, const Vertex* vertices, uint32_t end)
      : boxes_(vertices),
        mesh_(mesh),
        triangle_(mesh.triangles + (kOne ? end : mesh.leaf_offsets[end])),
        offset_(kOne ? nullptr : mesh.leaf_offsets + end) {}

  FLASHBVH_INLINE PackedBox take() {
    if constexpr (kOne) {
      return take_one();
    } else {
      uint32_t left = *offset_;
      left -= *--offset_;
      if (left == 1) {
        return take_one();
      }
      if (left == 2 && is_quad(triangle_[-2], triangle_[-1])) {
        return take_quad();
      }
      const auto* const end = triangle_;
      triangle_ -= left;
      return box_of_many(mesh_, end, triangle_);
    }
  }

  /// After those to come.
  uint32_t leaf() const {
    return static_cast<uint32_t>(kOne ? triangle_ - mesh_.triangles : offset_ - mesh_.leaf_offsets);
  }

 private:
  FLASHBVH_INLINE PackedBox take_one() {
    const auto& v = triangle_[-1].corner;
    const PackedBox box = boxes_.box_of(v[0], v[1], v[2]);
    --triangle_;
    return box;
  }
  FLASHBVH_INLINE PackedBox take_quad() {
    const auto& v = triangle_[-2].corner;
    const PackedBox box = boxes_.box_of(v[0], v[1], v[2], triangle_[-1].corner[0]);
    triangle_ -= 2;
    return box;
  }
  /// Apart from the loop over nodes, which needs the registers.
  FLASHBVH_NOINLINE static PackedBox box_of_many(const Mesh& mesh, const Corners<Index>* end,
                                                 const Corners<Index>* first) {
    LeafBoxes boxes(mesh, end);
    PackedBox box = {0, 0, 0};
    while (boxes.triangle_ != first) {
      const bool is_one =
          boxes.triangle_ - first == 1 || !is_quad(boxes.triangle_[-2], boxes.triangle_[-1]);
      add_box(box, is_one ? boxes.take_one() : boxes.take_quad());
    }
    return box;
  }

  LeafBoxes(const Mesh& mesh, const Corners<Index>* end)
      : boxes_(mesh.vertices), mesh_(mesh), triangle_(end), offset_(nullptr) {}

  VertexBoxes boxes_;
  const Mesh& mesh_;
  const Corners<Index>* triangle_;
  const Index* offset_;
};

/// Of all children of an internal node, `box` being that of the one right after it.
template <class Mesh>
FLASHBVH_INLINE inline void add_children(const Node<typename Mesh::Index>* nodes,
                                         const Node<typename Mesh::Index>* node, PackedBox& box) {
  const auto* child = nodes + node[1].link;
  if constexpr (Mesh::kLayout == Layout::post_indexed) {
    // Its own link where it is alone: once more does no harm.
    do {
      add_stored(box, child->box);
      child = nodes + child->link;
    } while (child != node + 1);
  } else {
    for (const auto* const end = nodes + node->link; child != end; child = nodes + child->link) {
      add_stored(box, child->box);
    }
  }
}

/// The boxes of `nodes` from `end` down to `begin`.
template <bool kOne, class Mesh>
FLASHBVH_NOINLINE void refit_nodes(Node<typename Mesh::Index>* nodes, uint32_t begin, uint32_t end,
                                   const Vertex* vertices, const Mesh& mesh, RefitPlace& place) {
  LeafBoxes<kOne, Mesh> leaves(mesh, vertices, place.leaf);
  PackedBox box = place.box;
  auto* node = nodes + end;
  auto* const first = nodes + begin;
  do {
    --node;
    if (node->is_leaf()) {
      box = leaves.take();
    } else {
      add_children<Mesh>(nodes, node, box);
    }
    node->box = box;
  } while (node != first);
  place = {leaves.leaf(), box};
}

}  // namespace flashbvh::detail

#endif
