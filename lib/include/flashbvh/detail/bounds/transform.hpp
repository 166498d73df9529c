// B's placement in A's lattice: translated, or also rotated. The pose decides which; a translation
// never pays for the arithmetic of a rotation.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/bounds/box.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/bounds/rotated_transform.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// One of a query's two trees.
enum class Side : uint8_t { none, a, b };

/// B translated by whole cells.
struct TranslatedTransform {
  Point offset;             ///< from B's lattice to A's; both count from their own origins
  TranslatedBoxTest bound;  ///< set by Transform::prepare()
};

/// A transform's way of placing B; from kMaxOffset on, `far_off` and `beyond` serve predicates of
/// distance alone.
enum class Placing : uint8_t {
  translated,
  rotated,
  far_off = 2,  ///< rotated and then moved by whole cells, even where nothing is rotated
  beyond,       ///< far off, but put at kMaxFarOffset, as it lies farther off
};

/// 92 bytes on a 32-bit core.
class Transform {
 public:
  /// Nothing is set before place() or place_nowhere().
  Transform() {}
  template <class Mesh>
  Transform(const Pose& pose, const Mesh& a, const Mesh& b, bool may_stop) {
    place(pose, a, b, may_stop, [] {});
  }

  /// Sets all members from a pose without an error. With `may_stop` it stops if the root boxes show
  /// that nothing can intersect. Calls `rest()` last, which sets the query's other members.
  /// Compilers make an end for each outcome, and drop stores that are never read: if place()
  /// returned first, a query of objects far apart would take 73 instructions for 51 on a Cortex-M4.
  template <class Mesh, class Rest>
  FLASHBVH_INLINE_FOR_SPEED void place(const Pose& pose, const Mesh& a, const Mesh& b,
                                       bool may_stop, const Rest& rest) {
    const auto end = [&](Placing placing, uint16_t slab_margin) {
      begin(placing, slab_margin);
      rest();
    };
    if (pose.is_translation()) {
      const auto along = [&](int axis) { return offset(pose, a, b, axis); };
      if (may_stop && boxes_disjoint(a.nodes[0].box, b.nodes[0].box, along)) {
        translated_.offset = {along(0), along(1), along(2)};
        end(Placing::translated, kDisjoint);
      } else {
        translated_.offset = {along(0), along(1), along(2)};
        end(Placing::translated, 0);
      }
    } else {
      const bool apart =
          !rotated_.prepare(pose, a.origin, a.nodes[0].box, b.origin, b.nodes[0].box, may_stop);
      apart ? end(Placing::rotated, kDisjoint) : end(Placing::rotated, 0);
    }
  }
  /// For a query with an error: no translation, no rotation.
  void place_nowhere() {
    begin(Placing::translated, 0);
    translated_.offset = {0, 0, 0};
  }

  /// For predicates of distance, after place(): places a B that is not near.
  void place_far(const Pose& pose, const int32_t (&origin_a)[3],
                 const int32_t (&origin_b)[3]) noexcept;
  /// Puts a translated B that is farther off than kMaxOffset along an axis at that distance, as
  /// place() does with a rotated B.
  void bring_near() {
    if (!is_rotated()) {
      Point& t = translated_.offset;
      t = {near_offset(t.x), near_offset(t.y), near_offset(t.z)};
    }
  }
  /// True if B lies within kMaxOffset along each axis; otherwise place() puts it nearer.
  bool is_near() const {
    const auto within = [](int32_t offset, int32_t most) {
      return -most < offset && offset < most;
    };
    if (!is_rotated()) {
      const Point& t = translated_.offset;
      return within(t.x, kMaxOffset) && within(t.y, kMaxOffset) && within(t.z, kMaxOffset);
    }
    constexpr int32_t most = kMaxOffset * kSplitOne;
    const BoxTestStart* const on_a = rotated_.on_a;
    return within(offset_of(on_a[0]), most) && within(offset_of(on_a[1]), most) &&
           within(offset_of(on_a[2]), most);
  }

  Placing placing() const { return placing_; }
  bool is_rotated() const { return placing_ != Placing::translated; }
  /// True after place_far(); is_beyond(): true if place_far() put B nearer than it lies.
  bool is_far() const { return placing_ >= Placing::far_off; }
  bool is_beyond() const { return placing_ == Placing::beyond; }
  /// The move of a far B after its rotation.
  const Point& far_offset() const { return rotated_.far_offset; }
  bool is_far_apart() const { return is_rotated() && roots_disjoint(); }
  const TranslatedTransform& translated() const { return translated_; }
  const RotatedTransform& rotated() const { return rotated_; }

  /// Lower limits for the packed words of a box of the other tree, to overlap a box of side `of`;
  /// after prepare().
  PackedTriple window_of(Side of, const PackedBox& box) const {
    if (!is_rotated()) {
      const TranslatedBoxTest& bound = translated_.bound;
      return of == Side::a ? bound.window_of_a(box) : bound.window_of_b(box);
    }
    return RotatedBoxTest::window_of(rotated_, of == Side::a, box);
  }

  /// True if place() separated the root boxes: this decides the commonest query, of objects far
  /// apart, before a walk is prepared.
  bool roots_disjoint() const { return slab_margin_ == kDisjoint; }

  /// True if no transformed edge of B is longer than 2^15 - 1 cells along an axis; after prepare().
  bool is_narrow() const { return narrow_; }
  /// The margin of slabs under a rotation, in units of their directions; after prepare(). For a far
  /// B it is larger by kFarMargin.
  int32_t slab_margin() const {
    return slab_margin_ * kMarginUnit + static_cast<int32_t>(placing_) / 2 * kFarMargin;
  }
  /// More than a bias and a lattice's reach together along any direction, each below 2^28.6.
  static constexpr int32_t kFarMargin = 1 << 30;

  /// Called before the first walk.
  template <class Mesh>
  void prepare(const Mesh& b) {
    if (!is_rotated()) {
      const Point& t = translated_.offset;
      translated_.bound = TranslatedBoxTest(t.x, t.y, t.z);
      narrow_ = true;
    } else {
      slab_margin_ = margin_of_slabs(reach(b.nodes[0].box));
      narrow_ = b.longest_edge <= kMostNarrowEdge;
    }
  }

 private:
  static constexpr uint16_t kDisjoint = UINT16_MAX;  ///< no margin is as large
  /// An edge of this length, stretched by a defect of at most 2^-12 and rounded at both ends, stays
  /// below 2^15.
  static constexpr uint16_t kMostNarrowEdge = 32700;
  static constexpr int32_t kMarginUnit = 16;

  FLASHBVH_INLINE void begin(Placing placing, uint16_t slab_margin) {
    placing_ = placing;
    narrow_ = false;
    slab_margin_ = slab_margin;
  }

  /// The error bound along a rotated direction of 13 bits. `reach_b`: reach() of B's root.
  uint16_t margin_of_slabs(int32_t reach_b) const {
    constexpr uint32_t most = 3u << 13;  // the sum of a direction's magnitudes
    constexpr uint32_t placed = 33'500;  // 0.51 for the vertices, 0.501 for the offset, times 2^15
    const uint32_t turned = (7 * static_cast<uint32_t>(reach_b) + 3) >> 2;
    const uint32_t stretched = static_cast<uint32_t>(reach_b) * rotated_.matrix->defect;
    const uint32_t each = turned + placed + (stretched >> 9);
    return static_cast<uint16_t>(((turned >> 1) + (each >> 2) * (most >> 13) + 20) / kMarginUnit +
                                 1);
  }

  static int32_t near_offset(int32_t offset) {
    return offset < -kMaxOffset ? -kMaxOffset : offset > kMaxOffset ? kMaxOffset : offset;
  }

  /// Wraps if the pose is out of range, which is an error of the pose.
  template <class Mesh>
  static int32_t offset(const Pose& pose, const Mesh& a, const Mesh& b, int axis) {
    return static_cast<int32_t>(static_cast<uint32_t>(pose.translation(axis)) +
                                static_cast<uint32_t>(b.origin[axis]) -
                                static_cast<uint32_t>(a.origin[axis]));
  }

  union {
    TranslatedTransform translated_;
    RotatedTransform rotated_;
  };
  Placing placing_;
  bool narrow_;
  uint16_t slab_margin_;  ///< in kMarginUnit; kDisjoint if the roots are disjoint
};

/// The offset of A's own triangles.
inline constexpr Point kNoOffset = {0, 0, 0};

/// Gets a mesh's triangle at `position`, translated by whole cells.
template <class Mesh>
FLASHBVH_NOINLINE void translate_triangle(const Mesh& mesh, uint32_t position, const Point& offset,
                                          Triangle& triangle) {
  const auto& corner = mesh.triangles[position].corner;
  const Point o = offset;
  const auto at = [&](int i) -> Point {
    const Vertex& v = mesh.vertices[corner[i]];
    return {v.x + o.x, v.y + o.y, v.z + o.z};
  };
  triangle = {{at(0), at(1), at(2)}};
}

/// Gets a translated triangle and its normal; every translated triangle is narrow.
template <class Mesh>
FLASHBVH_NOINLINE void translate_triangle(const Mesh& mesh, uint32_t position, const Point& offset,
                                          Triangle& triangle, PlaneNormal& normal) {
#if defined(__OPTIMIZE_SIZE__)
  translate_triangle(mesh, position, offset, triangle);
  get_near_normal(triangle, normal);
#else
  const auto& corner = mesh.triangles[position].corner;
  const Vertex& p = mesh.vertices[corner[0]];
  const Vertex& q = mesh.vertices[corner[1]];
  const Vertex& r = mesh.vertices[corner[2]];
  const Point u = {q.x - p.x, q.y - p.y, q.z - p.z};
  const Point v = {r.x - p.x, r.y - p.y, r.z - p.z};
  const Point o = offset;
  triangle = {{{p.x + o.x, p.y + o.y, p.z + o.z},
               {q.x + o.x, q.y + o.y, q.z + o.z},
               {r.x + o.x, r.y + o.y, r.z + o.z}}};
  normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
#endif
}

/// Gets a mesh's triangle at `position`, rotated and translated.
template <class Mesh>
FLASHBVH_NOINLINE void rotate_triangle(const Mesh& mesh, uint32_t position,
                                       const RotatedTransform& transform, Triangle& triangle) {
  const auto& corner = mesh.triangles[position].corner;
  transform.transform(mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]],
                      triangle);
}

/// Gets B's triangle at `position` in A's frame, relative to A's origin.
template <class Mesh>
void transform_triangle(const Mesh& b, uint32_t position, const Transform& transform,
                        Triangle& triangle) {
  if (transform.is_rotated()) {
    rotate_triangle(b, position, transform.rotated(), triangle);
  } else {
    translate_triangle(b, position, transform.translated().offset, triangle);
  }
}

/// Moves a triangle by whole cells.
void move(const Point& by, Triangle& triangle) noexcept;

/// transform_triangle() for a B that may be far.
template <class Mesh>
void transform_any_triangle(const Mesh& b, uint32_t position, const Transform& transform,
                            Triangle& triangle) {
  transform_triangle(b, position, transform, triangle);
  if (transform.is_far()) {
    move(transform.far_offset(), triangle);
  }
}

/// Gets a triangle of each mesh in A's frame as it was drawn.
template <class Mesh>
void place_pair(const Mesh& a, uint32_t of_a, const Mesh& b, uint32_t of_b,
                const Transform& transform, Triangle& triangle_a, Triangle& triangle_b) {
  const Point origin = {a.origin[0], a.origin[1], a.origin[2]};
  translate_triangle(a, of_a, origin, triangle_a);
  transform_any_triangle(b, of_b, transform, triangle_b);
  move(origin, triangle_b);
}

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
