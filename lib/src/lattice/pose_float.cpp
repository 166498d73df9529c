// Poses from floats with SSE2; without SSE2, float.hpp computes them in integers alone.
#include "flashbvh/detail/lattice/float_parts.hpp"

#if defined(FLASHBVH_POSE_SSE2)

#include "pose_sse2.hpp"

namespace flashbvh::detail {
namespace {

/// Translates a pose and returns true. False if the translation is out of range or not a number.
/// False also if `cells_per_unit` makes subnormals matter, which this core may flush to 0.
FLASHBVH_INLINE inline bool translate(Pose& pose, float x, float y, float z, float cells_per_unit) {
  constexpr uint32_t least = 0x0D800000;  // 2^-100
  constexpr uint32_t most = 0x71800000;   // 2^100
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &cells_per_unit, sizeof bits);
  if (bits - least >= most - least) {
    return false;
  }
  // A product has 48 bits: exact.
  const __m128d scale = _mm_mul_pd(_mm_cvtps_pd(_mm_set1_ps(cells_per_unit)), _mm_set1_pd(65536));
  const __m128d xy = half_added(_mm_mul_pd(_mm_cvtps_pd(_mm_set_ps(0, 0, y, x)), scale));
  const __m128d zz = half_added(_mm_mul_pd(_mm_cvtps_pd(_mm_set1_ps(z)), scale));
  // INT64_MIN if the number does not fit.
  const auto truncated = [](__m128d v) { return static_cast<uint64_t>(_mm_cvttsd_si64(v)); };
  // Half cells round up; after the addition, every value in range is positive.
  constexpr uint64_t raised = (uint64_t{kMaxTranslation} << 16) + 0x8000;
  const uint64_t along_x = truncated(xy) + raised;
  const uint64_t along_y = truncated(_mm_unpackhi_pd(xy, xy)) + raised;
  const uint64_t along_z = truncated(zz) + raised;
  if ((along_x | along_y | along_z) >= uint64_t{2} * kMaxTranslation << 16) {
    return false;
  }
  PoseOfLanes::translate(pose, 0, along_x);
  PoseOfLanes::translate(pose, 1, along_y);
  PoseOfLanes::translate(pose, 2, along_z);
  return true;
}

// For input that is refused above, mostly an error. Not inlined: these functions save registers.
[[gnu::noinline, gnu::cold]] Pose by_parts(const float (&rotation)[3][3],
                                           const float (&translation)[3], float cells_per_unit) {
  return pose_of_parts(rotation, translation, cells_per_unit);
}
[[gnu::noinline, gnu::cold]] Pose by_parts(const float (&matrix)[3][4], float cells_per_unit) {
  return pose_of_parts(matrix, cells_per_unit);
}

inline __m128 floats_of(float x, float y, float z) {
  return _mm_set_ps(0, z, y, x);
}

/// Rotates a pose; false, without changing it, if these are not the rows of a rotation.
FLASHBVH_INLINE inline bool rotate(Pose& pose, __m128 row0, __m128 row1, __m128 row2) {
  const GivenLanes u(row0);
  const GivenLanes v(row1);
  const GivenLanes w(row2);
  const auto is_none = [](__m128i whole) {
    return _mm_cmpeq_epi32(whole, _mm_set1_epi32(INT32_MIN));
  };
  const __m128i none =
      _mm_or_si128(_mm_or_si128(is_none(u.whole), is_none(v.whole)), is_none(w.whole));
  const MatrixLanes rows = {kept_lanes(u.nearest), kept_lanes(v.nearest), kept_lanes(w.nearest)};
  return PoseOfLanes::rotate(pose, rows, none);
}

}  // namespace

Pose pose_of_sse2(const float (&rotation)[3][3], const float (&translation)[3],
                  float cells_per_unit) {
  const auto row = [&](int i) { return floats_of(rotation[i][0], rotation[i][1], rotation[i][2]); };
  Pose pose = Pose::translated(0, 0, 0);
  if (!translate(pose, translation[0], translation[1], translation[2], cells_per_unit) ||
      !rotate(pose, row(0), row(1), row(2))) {
    pose = by_parts(rotation, translation, cells_per_unit);
  }
  return pose;
}

Pose pose_of_sse2(const float (&matrix)[3][4], float cells_per_unit) {
  const auto row = [&](int i) { return floats_of(matrix[i][0], matrix[i][1], matrix[i][2]); };
  Pose pose = Pose::translated(0, 0, 0);
  if (!translate(pose, matrix[0][3], matrix[1][3], matrix[2][3], cells_per_unit) ||
      !rotate(pose, row(0), row(1), row(2))) {
    pose = by_parts(matrix, cells_per_unit);
  }
  return pose;
}

Pose pose_of_sse2(const int32_t (&rotation)[3][3], const float (&translation)[3],
                  float cells_per_unit) {
  const auto row = [&](int i) {
    return kept_lanes(lanes_of(rotation[i][0], rotation[i][1], rotation[i][2]));
  };
  const MatrixLanes rows = {row(0), row(1), row(2)};
  Pose pose = Pose::translated(0, 0, 0);
  if (!translate(pose, translation[0], translation[1], translation[2], cells_per_unit) ||
      !PoseOfLanes::rotate(pose, rows, _mm_setzero_si128())) {
    pose = pose_of_parts(rotation, translation, cells_per_unit);
  }
  return pose;
}

}  // namespace flashbvh::detail

#endif
