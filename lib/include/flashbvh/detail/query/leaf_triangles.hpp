// Tests the triangles of two leaves at once with AVX2, if a query detects AVX2 at run time. Answers
// equal those of triangles_intersect(), bit for bit.
//
// A vector holds one corner per lane: a triangle's heights over a plane take three products, and
// two masks decide whether it lies on one side. A pair that no plane separates goes to the
// determinants of triangle.cpp, two per vector; a pair with a flat triangle goes to triangle.cpp.
#ifndef FLASHBVH_DETAIL_QUERY_LEAF_TRIANGLES_HPP
#define FLASHBVH_DETAIL_QUERY_LEAF_TRIANGLES_HPP

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/rotated_transform.hpp"
#include "flashbvh/detail/bounds/transform.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_LEAVES_AT_ONCE 1
#endif

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// True if the predicate tests any two triangles of two leaves, and only for intersection.
template <class Predicate>
inline constexpr bool kTestsAllAlike = Predicate::kIntersects;

/// A batch of pairs of leaves. On other processors, and if the predicate differs by triangle,
/// triangles are tested one pair after the other.
template <class LeafPairs, class Mesh, bool tests_all_alike>
struct Batches {
  using Batch = LeafPairs;
  static constexpr bool kAtOnce = false;
};

#if defined(FLASHBVH_LEAVES_AT_ONCE)

/// The most triangles of a leaf that is tested at once: the default of trees.
constexpr uint32_t kMostAtOnce = 2;

/// A narrow triangle in A's frame, one corner per lane. In cells, within +-2^17.
struct alignas(16) TriangleLanes {
  int64_t x[4];  ///< of the three corners, then of the last one again
  int64_t y[4];
  int64_t z[4];
  int64_t plane[4];      ///< its normal, and its height over the origin along the normal
  int32_t corner[3][4];  ///< the same corners, with 0 after each
};

/// The placement of vertices, one axis per lane.
struct alignas(16) VertexTransform {
  uint32_t entries_xy[4];  ///< signed halves
  uint32_t entries_z[4];
  uint32_t rest_xy[4];  ///< the lower bits of the entries (RotationMatrix)
  uint32_t rest_z[4];
  int32_t offset[4];  ///< of a translation: in cells

  void translate(const Point& by);
  void rotate(const RotatedTransform& by);
};

/// Place a triangle. `corner`: three vertices of a mesh. These and intersecting_pairs() need AVX2.
void take_translated(const VertexTransform& by, const Vertex* const (&corner)[3], TriangleLanes& t);
void take_rotated(const VertexTransform& by, const Vertex* const (&corner)[3], TriangleLanes& t);

/// The pairs of triangles that intersect: bit i + j * in_a for A's i-th and B's j-th.
uint32_t intersecting_pairs(const TriangleLanes* a, uint32_t in_a, const TriangleLanes* b,
                            uint32_t in_b);

/// Keeps all answers for the latest pair of leaves, and the triangles of both.
template <class Mesh>
class LeavesAtOnce {
 public:
  LeavesAtOnce(const Mesh& a, const Mesh& b) : a_(a), b_(b) {}

  /// True if a pair of leaves is tested here. All calls pass one transform.
  bool has(const Transform& transform, uint32_t leaf_a, uint32_t leaf_b) {
    if (!prepared_) {
      prepare(transform);
    }
    return usable_ && a_.mesh.triangles_in(leaf_a) <= kMostAtOnce &&
           b_.mesh.triangles_in(leaf_b) <= kMostAtOnce;
  }
  /// Lowers `untested` to the next pair of triangles that intersects; false, and 0, if none does.
  bool next_answer(uint32_t leaf_a, uint32_t leaf_b, uint16_t& untested) {
    const bool took_a = a_.take(leaf_a, of_a_, take_translated);
    const bool took_b = b_.take(leaf_b, of_b_, rotated_ ? take_rotated : take_translated);
    if (took_a || took_b) {
      answers_ = intersecting_pairs(a_.triangle, a_.count, b_.triangle, b_.count);
    }
    const uint32_t left = answers_ & ((1u << untested) - 1);
    untested = static_cast<uint16_t>(left != 0 ? 31 - __builtin_clz(left) : 0);
    return left != 0;
  }

 private:
  /// Called before a run's first pair.
  void prepare(const Transform& transform) {
    prepared_ = true;
    rotated_ = transform.is_rotated();
    // No triangle of A is too long.
    usable_ = transform.is_narrow() && __builtin_cpu_supports("avx2") != 0;
    of_a_.translate(kNoOffset);
    if (rotated_) {
      of_b_.rotate(transform.rotated());
    } else {
      of_b_.translate(transform.translated().offset);
    }
  }

  struct Leaf {
    const Mesh& mesh;
    uint32_t leaf = UINT32_MAX;
    uint32_t count = 0;
    TriangleLanes triangle[kMostAtOnce];

    explicit Leaf(const Mesh& of) : mesh(of) {}
    /// True if the leaf is not that of the last call.
    template <class Take>
    bool take(uint32_t requested, const VertexTransform& by, const Take& take_triangle) {
      if (requested == leaf) {
        return false;
      }
      leaf = requested;
      count = mesh.triangles_in(leaf);
      const uint32_t first = mesh.first_triangle(leaf);
      for (uint32_t i = 0; i < count; ++i) {
        const auto& corner = mesh.triangles[first + i].corner;
        const Vertex* const vertices = mesh.vertices;
        take_triangle(by, {vertices + corner[0], vertices + corner[1], vertices + corner[2]},
                      triangle[i]);
      }
      return true;
    }
  };

  Leaf a_;
  Leaf b_;
  bool prepared_ = false;
  bool usable_ = false;
  bool rotated_ = false;
  uint32_t answers_ = 0;
  VertexTransform of_a_;
  VertexTransform of_b_;
};

template <class LeafPairs, class Mesh>
struct Batches<LeafPairs, Mesh, true> {
  struct Batch : LeafPairs {
    Batch(const Mesh& a, const Mesh& b) : LeafPairs(a, b), at_once(a, b) {}

    LeavesAtOnce<Mesh> at_once;
  };
  static constexpr bool kAtOnce = true;
};

#endif

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop

#endif
