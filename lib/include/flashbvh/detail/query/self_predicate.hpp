// The predicate for a mesh against itself: a predicate of two meshes, on each unordered pair of
// triangles that share no vertex.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"
#include "flashbvh/detail/walk/walk.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// There are no leaf planes: neighbours always overlap, and a slab never separates them.
template <class Base>
struct SelfPredicate : Base {
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;

  SelfPredicate() = default;
  explicit SelfPredicate(const Base& base) : Base(base) {}
};

/// Selects the pairs of triangles that count.
template <class Mesh>
class SelfPairs {
 public:
  explicit SelfPairs(const Mesh& mesh) : mesh_(mesh) {}

  FLASHBVH_INLINE void take_b(uint32_t of_b) { of_b_ = of_b; }
  /// True once per pair, by the order in the array, unless the triangles share a vertex.
  FLASHBVH_INLINE bool counts(uint32_t of_a) const {
    if (of_a >= of_b_) {
      return false;
    }
    const auto& a = mesh_.triangles[of_a].corner;
    const auto& b = mesh_.triangles[of_b_].corner;
    const auto is_of_a = [&a](uint32_t v) { return v == a[0] || v == a[1] || v == a[2]; };
    return !is_of_a(b[0]) && !is_of_a(b[1]) && !is_of_a(b[2]);
  }
  /// For a pair that counts: true if B's triangle is a new one, which this then writes to `b`.
  FLASHBVH_INLINE bool place_b(Triangle& b) {
    if (placed_ == of_b_) {
      return false;
    }
    placed_ = of_b_;
    place(of_b_, b);
    return true;
  }
  FLASHBVH_INLINE void place(uint32_t position, Triangle& t) const {
    const auto& corner = mesh_.triangles[position].corner;
    for (int i = 0; i < 3; ++i) {
      const Vertex& v = mesh_.vertices[corner[i]];
      t.corner[i] = {v.x, v.y, v.z};
    }
  }
  uint32_t of_b() const { return of_b_; }

 private:
  const Mesh& mesh_;
  uint32_t of_b_ = UINT32_MAX;
  uint32_t placed_ = UINT32_MAX;
};

/// Leaves of neighbours always overlap, but their triangles seldom do: so cheap tests come first.
template <class Base, class Mesh>
class TriangleTest<SelfPredicate<Base>, Mesh, true> {
 public:
  TriangleTest(SelfPredicate<Base>&, const Mesh& mesh, const Mesh&, const Transform&)
      : pairs_(mesh) {}

  FLASHBVH_INLINE bool take_b(uint32_t of_b, const PackedBox* /*box_a*/) {
    pairs_.take_b(of_b);
    return true;
  }
  FLASHBVH_INLINE bool operator()(uint32_t of_a) {
    if (!pairs_.counts(of_a)) {
      return false;
    }
    if (pairs_.place_b(b_)) {
      has_normal_ = false;
    }
    Triangle a;
    pairs_.place(of_a, a);
    if (middles_separate(a, b_)) {
      return false;
    }
    if (!has_normal_) {
      get_near_normal(b_, normal_);
      has_normal_ = true;
    }
    return near_triangles_intersect(a, b_, normal_);
  }

 private:
  SelfPairs<Mesh> pairs_;
  bool has_normal_ = false;
  Triangle b_;
  PlaneNormal normal_;
};

template <class Base, class Mesh>
class TriangleTest<SelfPredicate<Base>, Mesh, false> {
 public:
  TriangleTest(SelfPredicate<Base>& predicate, const Mesh& mesh, const Mesh&, const Transform&)
      : predicate_(predicate), pairs_(mesh) {}

  bool take_b(uint32_t of_b, const PackedBox* /*box_a*/) {
    pairs_.take_b(of_b);
    return true;
  }
  bool operator()(uint32_t of_a) {
    if (!pairs_.counts(of_a)) {
      return false;
    }
    (void)pairs_.place_b(b_);
    Triangle a;
    pairs_.place(of_a, a);
    return predicate_.test(a, b_, of_a, pairs_.of_b());
  }

 private:
  SelfPredicate<Base>& predicate_;
  SelfPairs<Mesh> pairs_;
  Triangle b_;
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
