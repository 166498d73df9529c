// Tests pairs of triangles of two meshes, and keeps the data that consecutive pairs share.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The triangle of B that consecutive pairs share. It is placed when first needed, as rotating it
/// costs most. B may be far.
template <class Mesh>
class KeptTriangle {
 public:
  /// Sets the triangle; true if it is a new one.
  bool take(uint32_t position) {
    const bool is_new = position != position_;
    is_placed_ = is_placed_ && !is_new;
    position_ = position;
    return is_new;
  }
  uint32_t position() const { return position_; }
  FLASHBVH_INLINE const Triangle& placed(const Mesh& b, const Transform& transform) {
    if (!is_placed_) {
      is_placed_ = true;
      transform_any_triangle(b, position_, transform, triangle_);
    }
    return triangle_;
  }

 private:
  uint32_t position_ = UINT32_MAX;
  bool is_placed_ = false;
  Triangle triangle_;
};

/// The test of any predicate.
template <class Predicate, class Mesh, bool kIntersects>
class TriangleTest {
 public:
  TriangleTest(Predicate& predicate, const Mesh& a, const Mesh& b, const Transform& transform)
      : predicate_(predicate), a_(a), b_(b), transform_(transform) {}

  /// Sets B's triangle. False if it intersects nothing in `box_a`, unless that is null.
  bool take_b(uint32_t of_b, const PackedBox* /*box_a*/) {
    (void)kept_.take(of_b);
    return true;
  }
  /// Tests it against a triangle of A.
  bool operator()(uint32_t of_a) {
    Triangle a;
    translate_triangle(a_, of_a, kNoOffset, a);
    return predicate_.test(a, kept_.placed(b_, transform_), of_a, kept_.position());
  }

 private:
  Predicate& predicate_;
  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  KeptTriangle<Mesh> kept_;
};

/// The test of intersection, which also keeps the normal of B's triangle.
template <class Predicate, class Mesh>
class TriangleTest<Predicate, Mesh, true> {
 public:
  TriangleTest(Predicate&, const Mesh& a, const Mesh& b, const Transform& transform)
      : a_(a),
        b_(b),
        transform_(transform),
        narrow_(transform.is_narrow()),
        placing_(transform.placing()) {}

  FLASHBVH_INLINE bool take_b(uint32_t of_b, const PackedBox* box_a) {
    if (placing_ == Placing::translated) {
      if (of_b != kept_) {
        kept_ = of_b;
        translate_triangle(b_, of_b, transform_.translated().offset, kept_b_, normal_);
      }
      return true;
    }
    if (of_b != kept_) {
      kept_ = of_b;
      rotate_triangle(b_, of_b, transform_.rotated(), kept_b_);
      has_normal_ = !narrow_;
    }
    // A rotated box is wider than its contents; a translated box is not.
    if (box_a != nullptr && !box_overlaps(*box_a, kept_b_)) {
      return false;
    }
    if (!has_normal_) {
      has_normal_ = true;
      get_near_normal(kept_b_, normal_);
    }
    return true;
  }

  /// Reads A's triangle in place: translate_triangle() by 0 would take a call and nine sums.
  FLASHBVH_INLINE bool operator()(uint32_t of_a) const {
    const auto& corner = a_.triangles[of_a].corner;
    const auto at = [&](int i) {
      const Vertex& v = a_.vertices[corner[i]];
      return Point{v.x, v.y, v.z};
    };
    const Triangle a = {{at(0), at(1), at(2)}};
    return narrow_ ? near_triangles_intersect(a, kept_b_, normal_)
                   : wide_triangles_intersect(a, kept_b_);
  }

 private:
  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  uint32_t kept_ = UINT32_MAX;
  bool narrow_;
  Placing placing_;
  bool has_normal_ = false;  ///< or none is needed
  Triangle kept_b_;
  PlaneNormal normal_;
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
