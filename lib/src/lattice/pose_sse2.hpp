// Makes poses with SSE2: one row of the rotation per register, one entry per lane. Results equal
// those of pose.cpp's plain form and of float_parts.hpp, bit for bit. In any rounding mode, sums
// and products are exact in a double's 53 bits, and floats are rounded by truncation.
//
// The caller's numbers are loaded one by one, as they were probably just stored: a load that spans
// several stores waits until these have left the core.
#ifndef FLASHBVH_LATTICE_POSE_SSE2_HPP
#define FLASHBVH_LATTICE_POSE_SSE2_HPP

#include <emmintrin.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/pose.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The rows of a matrix: x, y, z and 0. Not an array, which compilers would keep in memory.
struct MatrixLanes {
  __m128i row0;
  __m128i row1;
  __m128i row2;
};

inline __m128i lanes_of(int32_t x, int32_t y, int32_t z) {
  return _mm_set_epi32(0, z, y, x);
}

/// Rounds entries with 30 fraction bits to kRotationBits; halves go up.
inline __m128i kept_lanes(__m128i given) {
  constexpr int dropped = 30 - static_cast<int>(kRotationBits);
  return _mm_srai_epi32(_mm_add_epi32(_mm_srai_epi32(given, dropped - 1), _mm_set1_epi32(1)), 1);
}

/// Made from bits: with -fno-signed-zeros a compiler may replace -0.0 by 0.
inline __m128d sign_bits() {
  return _mm_castsi128_pd(_mm_set1_epi64x(INT64_MIN));
}

/// Adds 1/2 to the magnitudes of two numbers, so that truncation rounds to the nearest, halves away
/// from zero. Exact, except for numbers so small that they are truncated to 0.
inline __m128d half_added(__m128d value) {
  const __m128d sign = _mm_and_pd(value, sign_bits());
  return _mm_add_pd(value, _mm_or_pd(sign, _mm_set1_pd(0.5)));
}

/// rotation_entry() of four floats below 2 in magnitude; for others `whole` holds INT32_MIN.
struct GivenLanes {
  __m128i whole;  ///< truncated
  __m128i nearest;

  explicit GivenLanes(__m128 row) {
    whole = _mm_cvttps_epi32(_mm_mul_ps(row, _mm_set1_ps(kRotationOne)));
    // The fraction is 1/2 or more if twice the number, truncated, exceeds twice `whole` by one.
    // Numbers from 1 on, whose double does not fit, have no fraction.
    const __m128i twice = _mm_cvttps_epi32(_mm_mul_ps(row, _mm_set1_ps(2.0f * kRotationOne)));
    const __m128i fits_not = _mm_cmpeq_epi32(twice, _mm_set1_epi32(INT32_MIN));
    const __m128i left = _mm_sub_epi32(twice, _mm_add_epi32(whole, whole));
    nearest = _mm_add_epi32(whole, _mm_andnot_si128(fits_not, left));
  }
};

/// Returns whether the matrix is exactly the identity and all bits of `wrong` are 0.
inline bool is_identity(const MatrixLanes& r, __m128i wrong) {
  constexpr int one = 1 << kRotationBits;
  if (_mm_cvtsi128_si32(r.row0) != one) {
    return false;  // nearly all matrices
  }
  const __m128i off = _mm_or_si128(_mm_or_si128(_mm_xor_si128(r.row0, lanes_of(one, 0, 0)), wrong),
                                   _mm_or_si128(_mm_xor_si128(r.row1, lanes_of(0, one, 0)),
                                                _mm_xor_si128(r.row2, lanes_of(0, 0, one))));
  return _mm_movemask_epi8(_mm_cmpeq_epi32(off, _mm_setzero_si128())) == 0xFFFF;
}

/// The determinant, in the first lane. It is about 1 or -1 and only its sign counts, so floats do.
inline __m128i determinant(const MatrixLanes& r) {
  const __m128 row0 = _mm_cvtepi32_ps(r.row0);
  const __m128 row1 = _mm_cvtepi32_ps(r.row1);
  const __m128 row2 = _mm_cvtepi32_ps(r.row2);
  const auto yzx = [](__m128 a) { return _mm_shuffle_ps(a, a, _MM_SHUFFLE(3, 0, 2, 1)); };
  // The cross product of the last rows in the order z, x, y.
  const __m128 zxy = _mm_sub_ps(_mm_mul_ps(row1, yzx(row2)), _mm_mul_ps(yzx(row1), row2));
  const __m128 terms = _mm_mul_ps(row0, yzx(zxy));
  const __m128 xz = _mm_add_ss(terms, _mm_movehl_ps(terms, terms));
  return _mm_castps_si128(_mm_add_ss(xz, _mm_shuffle_ps(terms, terms, 1)));
}

/// Two entries of R^T R - 1: magnitudes in 2^-kDefectBits, rounded up. `one`: subtracted from the
/// sums.
inline __m128i deviations(__m128d sums, __m128d one) {
  constexpr int32_t unit = 1 << (2 * kRotationBits - kDefectBits);
  const __m128d size = _mm_andnot_pd(sign_bits(), _mm_sub_pd(sums, one));
  const __m128d raised = _mm_add_pd(size, _mm_set1_pd(unit - 1));
  return _mm_cvttpd_epi32(_mm_mul_pd(raised, _mm_set1_pd(1.0 / unit)));
}

/// Products of a row's entries.
struct RowProducts {
  __m128d xx_yy;
  __m128d xz_yz;
  __m128d xy_zz;

  explicit RowProducts(__m128i row) {
    const __m128d xy = _mm_cvtepi32_pd(row);
    const __m128d zz = _mm_cvtepi32_pd(_mm_shuffle_epi32(row, _MM_SHUFFLE(2, 2, 2, 2)));
    xx_yy = _mm_mul_pd(xy, xy);
    xz_yz = _mm_mul_pd(xy, zz);
    xy_zz = _mm_mul_pd(_mm_unpacklo_pd(xy, zz), _mm_unpackhi_pd(xy, zz));
  }
};

/// Upper bound on the norm of R^T R - 1, as in pose.cpp.
struct ProofLanes {
  __m128i defect;  ///< in the first lane; valid if `over` is 0
  __m128i over;    ///< all bits set in each lane that is beyond `most`

  FLASHBVH_INLINE ProofLanes(const MatrixLanes& r, int32_t most) {
    const RowProducts u(r.row0);
    const RowProducts v(r.row1);
    const RowProducts w(r.row2);
    constexpr int64_t one = int64_t{1} << (2 * kRotationBits);
    const auto sum = [](__m128d a, __m128d b, __m128d c) {
      return _mm_add_pd(_mm_add_pd(a, b), c);
    };
    const __m128i xx_yy = deviations(sum(u.xx_yy, v.xx_yy, w.xx_yy), _mm_set1_pd(one));
    const __m128i xz_yz = deviations(sum(u.xz_yz, v.xz_yz, w.xz_yz), _mm_setzero_pd());
    const __m128i xy_zz = deviations(sum(u.xy_zz, v.xy_zz, w.xy_zz), _mm_set_pd(one, 0));
    const __m128i xy_xy = _mm_shuffle_epi32(xy_zz, _MM_SHUFFLE(3, 3, 0, 0));
    const __m128i yz_xz = _mm_shuffle_epi32(xz_yz, _MM_SHUFFLE(3, 3, 0, 1));
    // `of_x_y` holds rows x and y; the second lane of `of_z` holds row z.
    const __m128i of_x_y = _mm_add_epi32(_mm_add_epi32(xx_yy, xz_yz), xy_xy);
    const __m128i of_z = _mm_add_epi32(_mm_add_epi32(xz_yz, yz_xz), xy_zz);
    // 16 bits suffice if no entry is over.
    const __m128i second = _mm_srli_epi64(_mm_max_epi16(of_x_y, of_z), 32);
    defect = _mm_max_epi16(of_x_y, second);
    over = _mm_or_si128(_mm_cmpgt_epi32(_mm_unpacklo_epi64(xx_yy, xz_yz), _mm_set1_epi32(most)),
                        _mm_cmpgt_epi32(xy_zz, _mm_set1_epi32(most)));
  }
};

/// SplitRow::of() of a row's coarse entries, followed by 0.
inline __m128i split_lanes(__m128i row) {
  const __m128i half = _mm_set1_epi32(1 << (kRestBits - 1));
  const __m128i coarse = _mm_srai_epi32(_mm_add_epi32(row, half), kRestBits);
  const __m128i both = _mm_packs_epi32(coarse, _mm_sub_epi32(_mm_setzero_si128(), coarse));
  const __m128i xy_first = _mm_shuffle_epi32(both, _MM_SHUFFLE(3, 1, 2, 0));
  const __m128i ordered = _mm_shufflehi_epi16(xy_first, _MM_SHUFFLE(3, 1, 2, 0));
  return _mm_max_epi16(ordered, _mm_setzero_si128());
}

/// Nine consecutive words, from three rows of three words and a 0.
struct NineLanes {
  __m128i first;
  __m128i second;
  __m128i last;  ///< one word and three zeros

  NineLanes(__m128i u, __m128i v, __m128i w)
      : first(_mm_or_si128(u, _mm_slli_si128(v, 12))),
        second(_mm_castps_si128(
            _mm_shuffle_ps(_mm_castsi128_ps(v), _mm_castsi128_ps(w), _MM_SHUFFLE(1, 0, 2, 1)))),
        last(_mm_srli_si128(w, 8)) {}
};

/// RotationMatrix::rest in the first nine bytes: each entry's lowest byte. Other bytes are 0.
inline __m128i rest_bytes(const MatrixLanes& r) {
  const NineLanes entries(r.row0, r.row1, r.row2);
  const auto bytes = [](__m128i v) { return _mm_and_si128(v, _mm_set1_epi32(0xFF)); };
  return _mm_packus_epi16(_mm_packs_epi32(bytes(entries.first), bytes(entries.second)),
                          _mm_packs_epi32(bytes(entries.last), _mm_setzero_si128()));
}

/// Stores the matrix in three vectors, so that each member can be loaded from one of them. The
/// defect takes twice as long, so it is stored apart: a query's first test need not wait for it.
FLASHBVH_INLINE inline void store(const MatrixLanes& r, __m128i defect, RotationMatrix& matrix) {
  static_assert(sizeof matrix == 48 && sizeof matrix.rows == 36 && sizeof matrix.rest == 9 &&
                sizeof matrix.defect == 2);
  const NineLanes rows(split_lanes(r.row0), split_lanes(r.row1), split_lanes(r.row2));
  auto* const to = reinterpret_cast<__m128i*>(&matrix);
  _mm_storeu_si128(to, rows.first);
  _mm_storeu_si128(to + 1, rows.second);
  _mm_storeu_si128(to + 2, _mm_or_si128(rows.last, _mm_slli_si128(rest_bytes(r), 4)));
  matrix.defect = static_cast<uint16_t>(_mm_cvtsi128_si32(defect));
}

/// Makes poses from lanes.
struct PoseOfLanes {
  /// The largest deviation of an entry, in 2^-kDefectBits: pose.cpp's kMaxEntryDefect.
  static constexpr int32_t kMaxDeviation = kRotationTolerance >> (30 - kDefectBits);

  /// Adds a rotation to a translation. False, without changing it, if `r` is not a rotation or
  /// `wrong` is not 0. Entries have kRotationBits.
  FLASHBVH_INLINE static bool rotate(Pose& pose, const MatrixLanes& r, __m128i wrong) {
    if (is_identity(r, wrong)) {
      return true;
    }
    const ProofLanes proof(r, kMaxDeviation);
    const __m128i mirrored = _mm_srai_epi32(_mm_shuffle_epi32(determinant(r), 0), 31);
    if (_mm_movemask_epi8(_mm_or_si128(_mm_or_si128(proof.over, wrong), mirrored)) != 0) {
      return false;
    }
    pose.rotated_ = true;
    store(r, proof.defect, pose.matrix_);
    return true;
  }

  /// Translates along an axis, within the range. `raised`: in 1/65,536 cell, plus kMaxTranslation
  /// and half a cell.
  FLASHBVH_INLINE static void translate(Pose& pose, int axis, uint64_t raised) {
    pose.cells_[axis] = static_cast<int32_t>(raised >> 16) - kMaxTranslation;
    pose.fraction_[axis] = static_cast<int16_t>(raised - 0x8000);
  }
};

}  // namespace flashbvh::detail

#endif
