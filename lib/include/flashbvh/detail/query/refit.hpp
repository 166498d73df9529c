// Boxes of a tree whose vertices moved, from the leaves up, in one pass.
//
// In both layouts a node lies before its subtrees. Backwards in the array, children come before
// their parents, and the box of a parent's first child is still in registers when the parent
// follows. Leaves and their triangles also come in the array's order, so no index is looked up.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// The larger of u and v, half by half.
inline uint32_t larger_halves(uint32_t u, uint32_t v) {
  return subtract_halves(u, v) + v;
}
FLASHBVH_INLINE inline void add_box(PackedBox& box, PackedBox other) {
  box.upper_xy = larger_halves(box.upper_xy, other.upper_xy);
  box.lower_xy = larger_halves(box.lower_xy, other.lower_xy);
  box.z = larger_halves(box.z, other.z);
}

/// Bits that are set in a bound beyond the lattice, and in that bound of every enclosing box.
constexpr uint32_t kBeyondLattice = 0x80008000;
constexpr bool is_in_lattice(const PackedBox& box) {
  return ((box.upper_xy | box.lower_xy | box.z) & kBeyondLattice) == 0;
}
constexpr bool is_in_lattice(const Vertex& v) {
  const auto fits = [](int32_t at) { return -kMaxCoordinate <= at && at <= kMaxCoordinate; };
  return fits(v.x) && fits(v.y) && fits(v.z);
}

/// Bounding boxes of vertices, which are given by their numbers.
#if defined(__ARM_FEATURE_SIMD32) && !defined(FLASHBVH_PORTABLE)

/// Compares signed halves and adds the bias once per box; a half beyond the lattice wraps to 2^15
/// or more. Empty assembly hides the constants from the compiler, which would make them per vertex.
class VertexBoxes {
 public:
  explicit VertexBoxes(const Vertex* vertices)
      : xy_(reinterpret_cast<const char*>(vertices)), z_(xy_ + offsetof(Vertex, z)) {
    __asm__("" : "+r"(z_), "+r"(negative_high_), "+r"(raise_));
  }

  /// Bounds of x and y, half by half; `z` as in a box.
  struct Span {
    uint32_t most;
    uint32_t least;
    uint32_t z;
  };

  FLASHBVH_INLINE Span span_of(uint32_t u, uint32_t v) const {
    const Corner of_u = corner(u);
    const Corner of_v = corner(v);
    return pair(of_u.xy, of_v.xy, larger(of_u.z, of_v.z));
  }
  FLASHBVH_INLINE Span with(const Span& span, uint32_t u) const {
    const Corner of_u = corner(u);
    return joined(span, {of_u.xy, of_u.xy, larger(span.z, of_u.z)});
  }
  FLASHBVH_INLINE Span with(const Span& span, uint32_t u, uint32_t v) const {
    const Corner of_u = corner(u);
    const uint32_t z = larger(span.z, of_u.z);
    const Corner of_v = corner(v);
    return joined(span, pair(of_u.xy, of_v.xy, larger(z, of_v.z)));
  }
  FLASHBVH_INLINE PackedBox packed(const Span& span) const {
    return {__uadd16(span.most, raise_), __usub16(raise_, span.least), span.z};
  }

 private:
  static constexpr uint32_t kRaise = kBoundBias * 0x10001u;

  struct Corner {
    uint32_t xy;
    uint32_t z;  ///< z + bias low, bias - z high: one product and a sum
  };
  /// Returns `value`, computed before later code begins: registers suffice for one vertex at a
  /// time.
  FLASHBVH_INLINE static uint32_t finished(uint32_t value) {
    __asm__ volatile("" : "+r"(value));
    return value;
  }
  FLASHBVH_INLINE static uint32_t larger(uint32_t u, uint32_t v) {
    return finished(larger_halves(u, v));
  }
  FLASHBVH_INLINE Corner corner(uint32_t vertex) const {
    uint32_t xy;
    int16_t z;
    __builtin_memcpy(&xy, xy_ + vertex * sizeof(Vertex), sizeof xy);
    __builtin_memcpy(&z, z_ + vertex * sizeof(Vertex), sizeof z);
    return {xy, finished(static_cast<uint32_t>(z) * negative_high_ + raise_)};
  }
  FLASHBVH_INLINE static Span pair(uint32_t u, uint32_t v, uint32_t z) {
    Span span;
    span.z = z;
    __asm__("ssub16 %0, %2, %3\n\tsel %0, %2, %3\n\tsel %1, %3, %2"
            : "=&r"(span.most), "=r"(span.least)
            : "r"(u), "r"(v));
    return span;
  }
  FLASHBVH_INLINE static Span joined(const Span& p, const Span& q) {
    Span span;
    span.z = q.z;
    __asm__("ssub16 %0, %1, %2\n\tsel %0, %1, %2" : "=&r"(span.most) : "r"(p.most), "r"(q.most));
    __asm__("ssub16 %0, %1, %2\n\tsel %0, %2, %1" : "=&r"(span.least) : "r"(p.least), "r"(q.least));
    return span;
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

  FLASHBVH_INLINE Box span_of(uint32_t u, uint32_t v) const {
    return with({vertices_[u], vertices_[u]}, v);
  }
  template <class... Numbers>
  FLASHBVH_INLINE Box with(Box box, Numbers... vertices) const {
    (add(box, vertices_[vertices]), ...);
    return box;
  }
  FLASHBVH_INLINE static PackedBox packed(const Box& box) {
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

/// The box's diagonal, rounded up: a bound on the edges in it.
inline uint16_t longest_edge_in(const PackedBox& box) {
  const int64_t x = extent_x(box);
  const int64_t y = extent_y(box);
  const int64_t z = extent_z(box);
  return static_cast<uint16_t>(square_root(widened(x * x + y * y + z * z)) + 1);
}

/// The state of a refit between two nodes; a node's box is made of the nodes after it.
struct RefitPlace {
  uint32_t leaf;  ///< the end of the remaining leaves
  PackedBox box;  ///< of the last node done, which lies after the next one
};

/// The boxes of leaves, from the last leaf to the first. `kOne`: each leaf has one triangle.
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
      if (left == 2) {
        return take_two();
      }
      if (left == 1) {
        return take_one();
      }
      const auto* const end = triangle_;
      triangle_ -= left;
      return box_of_many(mesh_, end, triangle_);
    }
  }

  /// The end of the remaining leaves.
  uint32_t leaf() const {
    return static_cast<uint32_t>(kOne ? triangle_ - mesh_.triangles : offset_ - mesh_.leaf_offsets);
  }

 private:
  FLASHBVH_INLINE PackedBox take_one() {
    const auto& v = triangle_[-1].corner;
    const PackedBox box = boxes_.packed(boxes_.with(boxes_.span_of(v[0], v[1]), v[2]));
    --triangle_;
    return box;
  }
  /// `kQuad`: the two triangles are known to share an edge.
  template <bool kQuad = false>
  FLASHBVH_INLINE PackedBox take_two() {
    const auto& u = triangle_[-2].corner;
    const auto& v = triangle_[-1].corner;
    auto span = boxes_.with(boxes_.span_of(u[0], u[1]), u[2], v[0]);
    if (!kQuad && !is_quad(triangle_[-2], triangle_[-1])) {
      span = boxes_.with(span, v[1], v[2]);
    }
    triangle_ -= 2;
    return boxes_.packed(span);
  }
  /// Kept out of the loop over nodes, which needs the registers.
  FLASHBVH_NOINLINE static PackedBox box_of_many(const Mesh& mesh, const Corners<Index>* end,
                                                 const Corners<Index>* first) {
    LeafBoxes boxes(mesh, end);
    PackedBox box = {0, 0, 0};
    while (boxes.triangle_ != first) {
      const bool is_one =
          boxes.triangle_ - first == 1 || !is_quad(boxes.triangle_[-2], boxes.triangle_[-1]);
      add_box(box, is_one ? boxes.take_one() : boxes.template take_two<true>());
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

/// Adds the boxes of all children of an internal node to `box`, which is its first child's.
template <class Mesh>
FLASHBVH_INLINE inline void add_children(const Node<typename Mesh::Index>* nodes,
                                         const Node<typename Mesh::Index>* node, PackedBox& box) {
  const auto* child = nodes + node[1].link;
  if constexpr (Mesh::kLayout == Layout::post_indexed) {
    // An only child is its own link, and is added twice.
    do {
      add_box(box, child->box);
      child = nodes + child->link;
    } while (child != node + 1);
  } else {
    for (const auto* const end = nodes + node->link; child != end; child = nodes + child->link) {
      add_box(box, child->box);
    }
  }
}

/// Sets the boxes of `nodes` from `end` down to `begin`.
template <bool kOne, class Mesh>
FLASHBVH_NOINLINE void refit_nodes(Node<typename Mesh::Index>* nodes, uint32_t begin, uint32_t end,
                                   const Vertex* vertices, const Mesh& mesh, RefitPlace& place) {
  LeafBoxes<kOne, Mesh> leaves(mesh, vertices, place.leaf);
  PackedBox box = place.box;
  auto* node = nodes + end;
  auto* const first = nodes + begin;
  do {
    --node;
    if (!node->is_leaf()) {
      add_children<Mesh>(nodes, node, box);
    } else {
      box = leaves.take();
    }
    node->box = box;
  } while (node != first);
  place = {leaves.leaf(), box};
}

}  // namespace flashbvh::detail
