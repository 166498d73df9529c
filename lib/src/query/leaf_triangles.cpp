#include "flashbvh/detail/query/leaf_triangles.hpp"

#if defined(FLASHBVH_LEAVES_AT_ONCE)

#include <immintrin.h>
#include <string.h>

#include "../predicates/orientation.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"

/// Compiles a function for AVX2, whatever the target of other functions.
#define FLASHBVH_AVX2 [[gnu::target("avx2")]]

namespace flashbvh::detail {
namespace avx2 {
namespace {

FLASHBVH_AVX2 inline __m128i all_of(const uint32_t (&words)[4]) {
  return _mm_load_si128(reinterpret_cast<const __m128i*>(words));
}
FLASHBVH_AVX2 inline __m128i all_of(const int32_t (&words)[4]) {
  return _mm_load_si128(reinterpret_cast<const __m128i*>(words));
}
FLASHBVH_AVX2 inline __m256i all_of(const int64_t (&words)[4]) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(words));
}
FLASHBVH_AVX2 inline void store(__m128i from, int32_t (&words)[4]) {
  _mm_store_si128(reinterpret_cast<__m128i*>(words), from);
}
FLASHBVH_AVX2 inline void store(__m256i from, int64_t (&words)[4]) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(words), from);
}

/// Loads a vertex's six bytes as three 16-bit lanes.
FLASHBVH_AVX2 inline __m128i load(const Vertex& v) {
  int32_t xy = 0;
  memcpy(&xy, &v, sizeof xy);
  return _mm_insert_epi16(_mm_cvtsi32_si128(xy), v.z, 2);
}
FLASHBVH_AVX2 inline __m128i translated(const VertexTransform& by, const Vertex& v) {
  return _mm_add_epi32(_mm_cvtepi16_epi32(load(v)), all_of(by.offset));
}
/// RotatedTransform::transform() on all three axes at once.
FLASHBVH_AVX2 inline __m128i rotated(const VertexTransform& by, const Vertex& v) {
  const __m128i halves = load(v);
  const __m128i xy = _mm_shuffle_epi32(halves, 0x00);
  const __m128i z = _mm_shuffle_epi32(halves, 0x55);
  const __m128i rest =
      _mm_add_epi32(_mm_madd_epi16(all_of(by.rest_xy), xy), _mm_madd_epi16(all_of(by.rest_z), z));
  const __m128i sum = _mm_add_epi32(_mm_madd_epi16(all_of(by.entries_xy), xy),
                                    _mm_madd_epi16(all_of(by.entries_z), z));
  return _mm_srai_epi32(
      _mm_add_epi32(_mm_add_epi32(sum, all_of(by.offset)), _mm_srai_epi32(rest, kRestBits)),
      kSplitBits);
}

/// The cross products of both 128-bit halves; components fit 32 bits.
FLASHBVH_AVX2 inline __m256i cross(__m256i u, __m256i v) {
  constexpr int yzx = 0xC9;
  constexpr int zxy = 0xD2;
  return _mm256_sub_epi32(
      _mm256_mullo_epi32(_mm256_shuffle_epi32(u, yzx), _mm256_shuffle_epi32(v, zxy)),
      _mm256_mullo_epi32(_mm256_shuffle_epi32(u, zxy), _mm256_shuffle_epi32(v, yzx)));
}

FLASHBVH_AVX2 inline void take(__m128i p, __m128i q, __m128i r, TriangleLanes& t) {
  store(p, t.corner[0]);
  store(q, t.corner[1]);
  store(r, t.corner[2]);
  const __m128i pq_xy = _mm_unpacklo_epi32(p, q);
  const __m128i rr_xy = _mm_unpacklo_epi32(r, r);
  const __m128i z = _mm_unpacklo_epi64(_mm_unpackhi_epi32(p, q), _mm_unpackhi_epi32(r, r));
  store(_mm256_cvtepi32_epi64(_mm_unpacklo_epi64(pq_xy, rr_xy)), t.x);
  store(_mm256_cvtepi32_epi64(_mm_unpackhi_epi64(pq_xy, rr_xy)), t.y);
  store(_mm256_cvtepi32_epi64(z), t.z);

  const __m256i both = cross(_mm256_castsi128_si256(_mm_sub_epi32(q, p)),
                             _mm256_castsi128_si256(_mm_sub_epi32(r, p)));
  const __m256i normal = _mm256_cvtepi32_epi64(_mm256_castsi256_si128(both));
  const __m256i products = _mm256_mul_epi32(normal, _mm256_cvtepi32_epi64(p));
  const __m128i sums =
      _mm_add_epi64(_mm256_castsi256_si128(products), _mm256_extracti128_si256(products, 1));
  const __m128i height = _mm_add_epi64(sums, _mm_unpackhi_epi64(sums, sums));
  store(_mm256_blend_epi32(normal, _mm256_broadcastq_epi64(height), 0xC0), t.plane);
}

/// The sides of the plane of `face` on which the corners of `t` lie.
FLASHBVH_AVX2 inline Sides sides_of(const TriangleLanes& face, const TriangleLanes& t) {
  const __m256i x = _mm256_mul_epi32(_mm256_set1_epi64x(face.plane[0]), all_of(t.x));
  const __m256i y = _mm256_mul_epi32(_mm256_set1_epi64x(face.plane[1]), all_of(t.y));
  const __m256i z = _mm256_mul_epi32(_mm256_set1_epi64x(face.plane[2]), all_of(t.z));
  const __m256i sum = _mm256_add_epi64(_mm256_add_epi64(x, y), z);
  const __m256i plane = _mm256_set1_epi64x(face.plane[3]);
  const int above = _mm256_movemask_pd(_mm256_castsi256_pd(_mm256_cmpgt_epi64(sum, plane)));
  const int below = _mm256_movemask_pd(_mm256_castsi256_pd(_mm256_cmpgt_epi64(plane, sum)));
  return {(static_cast<unsigned>(above) & kAllCorners) |
          (static_cast<unsigned>(below) & kAllCorners) << 3};
}

FLASHBVH_AVX2 inline __m256i join(const int32_t (&low)[4], const int32_t (&high)[4]) {
  return _mm256_inserti128_si256(_mm256_castsi128_si256(all_of(low)), all_of(high), 1);
}

/// intervals_overlap() of triangle.cpp with both determinants at once; the lower half holds the
/// determinant of the high ends.
FLASHBVH_AVX2 inline bool intervals_overlap(const TriangleLanes& a, Sides of_a,
                                            const TriangleLanes& b, Sides of_b) {
  const Tip at = tip_of(of_a);
  const Tip bt = tip_of(of_b);
  const unsigned high_a = bt.up ? next(at.corner) : previous(at.corner);
  const unsigned low_a = bt.up ? previous(at.corner) : next(at.corner);
  const unsigned high_b = at.up ? next(bt.corner) : previous(bt.corner);
  const unsigned low_b = at.up ? previous(bt.corner) : next(bt.corner);
  const __m256i tip_a = _mm256_broadcastsi128_si256(all_of(a.corner[at.corner]));
  const __m256i tip_b = _mm256_broadcastsi128_si256(all_of(b.corner[bt.corner]));
  const __m256i edges_a = _mm256_sub_epi32(join(a.corner[high_a], a.corner[low_a]), tip_a);
  const __m256i edges_b = _mm256_sub_epi32(join(b.corner[high_b], b.corner[low_b]), tip_b);
  const __m256i between = _mm256_sub_epi32(tip_b, tip_a);
  const __m256i normals = cross(edges_b, edges_a);
  const __m256i sums = _mm256_add_epi64(
      _mm256_mul_epi32(normals, between),
      _mm256_mul_epi32(_mm256_srli_epi64(normals, 32), _mm256_srli_epi64(between, 32)));
  const __m256i volumes = _mm256_add_epi64(sums, _mm256_unpackhi_epi64(sums, sums));
  return _mm_cvtsi128_si64(_mm256_castsi256_si128(volumes)) <= 0 &&
         _mm_cvtsi128_si64(_mm256_extracti128_si256(volumes, 1)) >= 0;
}

Triangle triangle_of(const TriangleLanes& t) {
  const auto at = [&](int i) { return Point{t.corner[i][0], t.corner[i][1], t.corner[i][2]}; };
  return {{at(0), at(1), at(2)}};
}
/// For a triangle that lies in the other's plane or has no area.
[[gnu::noinline, gnu::cold]] bool flat_intersect(const TriangleLanes& a, const TriangleLanes& b) {
  return triangles_intersect(triangle_of(a), triangle_of(b));
}

FLASHBVH_AVX2 inline bool intersect(const TriangleLanes& a, const TriangleLanes& b) {
  const Sides of_a = sides_of(b, a);
  if (of_a.separate()) {
    return false;
  }
  const Sides of_b = sides_of(a, b);
  if (of_b.separate()) {
    return false;
  }
  return of_a.all_on_plane() || of_b.all_on_plane() ? flat_intersect(a, b)
                                                    : intervals_overlap(a, of_a, b, of_b);
}

}  // namespace
}  // namespace avx2

void VertexTransform::translate(const Point& by) {
  *this = {{}, {}, {}, {}, {by.x, by.y, by.z, 0}};
}

void VertexTransform::rotate(const RotatedTransform& by) {
  *this = {};
  const auto join = [](int32_t u, int32_t v) {
    return join_halves(static_cast<uint16_t>(u), static_cast<uint16_t>(v));
  };
  for (int i = 0; i < 3; ++i) {
    const SplitRow& row = by.matrix->rows.row[i];
    const int8_t(&rest)[3] = by.matrix->rest[i];
    entries_xy[i] = join(row.x(), row.y());
    entries_z[i] = join(row.z_entry(), 0);
    rest_xy[i] = join(rest[0], rest[1]);
    rest_z[i] = join(rest[2], 0);
    offset[i] = offset_of(by.on_a[i]) + kSplitOne / 2;
  }
}

FLASHBVH_AVX2 void take_translated(const VertexTransform& by, const Vertex* const (&corner)[3],
                                   TriangleLanes& t) {
  using avx2::translated;
  avx2::take(translated(by, *corner[0]), translated(by, *corner[1]), translated(by, *corner[2]), t);
}
FLASHBVH_AVX2 void take_rotated(const VertexTransform& by, const Vertex* const (&corner)[3],
                                TriangleLanes& t) {
  using avx2::rotated;
  avx2::take(rotated(by, *corner[0]), rotated(by, *corner[1]), rotated(by, *corner[2]), t);
}

FLASHBVH_AVX2 uint32_t intersecting_pairs(const TriangleLanes* a, uint32_t in_a,
                                          const TriangleLanes* b, uint32_t in_b) {
  uint32_t answers = 0;
  for (uint32_t j = 0; j < in_b; ++j) {
    for (uint32_t i = 0; i < in_a; ++i) {
      answers |= (avx2::intersect(a[i], b[j]) ? 1u : 0u) << (i + j * in_a);
    }
  }
  return answers;
}

}  // namespace flashbvh::detail

#endif
