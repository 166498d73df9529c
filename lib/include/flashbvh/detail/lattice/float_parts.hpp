// Splits floats into parts by their bits, for float.hpp, which calculates in integers alone.
#pragma once

#include <stdint.h>

#include "flashbvh/pose.hpp"

namespace flashbvh {

/// The tolerance of a quaternion's squared length around 1: 2^-10, in the fixed point of a
/// rotation. Quaternions of four decimals pass, and those of a sensor with 14 bits.
constexpr int32_t kQuaternionTolerance = kRotationOne >> 10;

/// w is the cosine of half the angle, (x, y, z) the axis times its sine. q and -q rotate alike.
struct UnitQuaternion {
  float w;
  float x;
  float y;
  float z;
};

namespace detail {

/// +-digits * 2^exponent, if finite.
struct FloatParts {
  uint32_t digits;  ///< below 2^24
  int32_t exponent;
  bool is_negative;
  bool is_finite;
};

inline FloatParts parts_of(float value) {
  static_assert(sizeof(float) == sizeof(uint32_t), "a binary32");
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  const uint32_t fraction = bits & 0x7FFFFFu;
  const uint32_t biased = bits >> 23 & 0xFFu;
  const bool is_subnormal = biased == 0;
  return {is_subnormal ? fraction : fraction | 0x800000u,
          static_cast<int32_t>(is_subnormal ? 1 : biased) - 150, bits >> 31 != 0, biased != 0xFFu};
}

inline float float_of(uint32_t bits) {
  float value = 0;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

/// Beyond every number that a pose accepts.
constexpr int64_t kTooLarge = int64_t{1} << 46;

/// digits * 2^exponent, rounded to the nearest, halves up; kTooLarge if it is that or more.
/// `digits` is below 2^48.
inline int64_t scaled(uint64_t digits, int32_t exponent) {
  if (exponent < -48 || digits == 0) {
    return 0;  // below a half
  }
  if (exponent < 0) {
    const uint64_t half = uint64_t{1} << (-exponent - 1);
    digits = (digits + half) >> -exponent;
    exponent = 0;
  }
  const bool fits = exponent < 46 && digits <= static_cast<uint64_t>(kTooLarge) >> exponent;
  return fits ? static_cast<int64_t>(digits << exponent) : kTooLarge;
}

/// `value` in the fixed point of a rotation; INT32_MAX, which no rotation has, for magnitudes of 2
/// and more and for values that are not finite.
inline int32_t rotation_entry(float value) {
  const FloatParts parts = parts_of(value);
  const int64_t size = parts.is_finite ? scaled(parts.digits, parts.exponent + 30) : kTooLarge;
  if (size > INT32_MAX) {
    return INT32_MAX;
  }
  return static_cast<int32_t>(parts.is_negative ? -size : size);
}

/// `length` in 1/65,536 cell; kTooLarge if out of range.
inline int64_t cell_fractions(float length, float cells_per_unit) {
  const FloatParts t = parts_of(length);
  const FloatParts scale = parts_of(cells_per_unit);
  if (!t.is_finite || !scale.is_finite || scale.is_negative || scale.digits == 0) {
    return kTooLarge;
  }
  const int64_t size =
      scaled(static_cast<uint64_t>(t.digits) * scale.digits, t.exponent + scale.exponent + 16);
  return t.is_negative && size != kTooLarge ? -size : size;
}

/// True if `value` is negative, however small; false for -0. Uses bits, as a core may have no FPU.
inline bool is_below_zero(float value) {
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits > 0x80000000u;
}

/// The least number of 1/256 cell that is at least `length`; UINT32_MAX if out of range. 1 / cell
/// is at most half a digit above `cells_per_unit`, or equal to it if this is a power of two
/// (cells_per_unit_bits()).
inline uint32_t fine_steps_above(float length, float cells_per_unit) {
  const FloatParts t = parts_of(length);
  const FloatParts scale = parts_of(cells_per_unit);
  if (!t.is_finite || is_below_zero(length) || !scale.is_finite || scale.is_negative ||
      scale.digits == 0) {
    return UINT32_MAX;
  }
  const uint64_t most = uint64_t{2} * scale.digits + (scale.digits == 0x800000 ? 0 : 1);
  const uint64_t digits = t.digits * most;  // below 2^49
  const int32_t exponent = t.exponent + scale.exponent + 7;
  if (exponent < -48 || digits == 0) {
    return digits == 0 ? 0 : 1;
  }
  if (exponent < 0) {
    const uint64_t steps = (digits + (uint64_t{1} << -exponent) - 1) >> -exponent;
    return steps < UINT32_MAX ? static_cast<uint32_t>(steps) : UINT32_MAX;
  }
  return exponent < 32 && digits < UINT32_MAX >> exponent
             ? static_cast<uint32_t>(digits << exponent)
             : UINT32_MAX;
}

/// pose_of() by integers alone, from a rotation in fixed point or in floats.
inline Pose pose_of_parts(const int32_t (&rotation)[3][3], const float (&translation)[3],
                          float cells_per_unit) {
  int32_t cells[3];
  int16_t fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int64_t fractions = cell_fractions(translation[axis], cells_per_unit);
    const int64_t whole = (fractions + 0x8000) >> 16;  // at most 2^30, which Pose refuses
    cells[axis] = static_cast<int32_t>(whole);
    fraction[axis] = static_cast<int16_t>(fractions - whole * 0x10000);
  }
  return Pose::rigid(rotation, cells, fraction);
}

inline Pose pose_of_parts(const float (&rotation)[3][3], const float (&translation)[3],
                          float cells_per_unit) {
  int32_t entries[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      entries[i][j] = rotation_entry(rotation[i][j]);
    }
  }
  return pose_of_parts(entries, translation, cells_per_unit);
}

inline Pose pose_of_parts(const float (&matrix)[3][4], float cells_per_unit) {
  int32_t entries[3][3];
  float translation[3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      entries[i][j] = rotation_entry(matrix[i][j]);
    }
    translation[i] = matrix[i][3];
  }
  return pose_of_parts(entries, translation, cells_per_unit);
}

/// The product of two numbers in the fixed point of a rotation, rounded down.
inline int64_t rotation_product(int64_t u, int64_t v) {
  return (u * v) >> 30;
}

/// Sets the matrix of the normalised quaternion; each entry is within 2^-27 of the exact result for
/// these floats. Takes one division. The first entry is INT32_MAX if `q` is no unit quaternion.
inline void set_rotation(const UnitQuaternion& q, int32_t (&rotation)[3][3]) {
  const int64_t part[4] = {rotation_entry(q.w), rotation_entry(q.x), rotation_entry(q.y),
                           rotation_entry(q.z)};
  int64_t square = 0;  // 60 fraction bits
  bool is_unit = true;
  for (const int64_t p : part) {
    is_unit = is_unit && p <= kRotationOne + kQuaternionTolerance &&
              p >= -kRotationOne - kQuaternionTolerance;
    square += is_unit ? p * p : 0;
  }
  const int64_t off = (square >> 30) - kRotationOne;
  rotation[0][0] = INT32_MAX;
  if (!is_unit || off > kQuaternionTolerance || off < -kQuaternionTolerance) {
    return;
  }
  // 2 / |q|^2: an entry is this times a sum of two products, less 1 on the diagonal.
  const int64_t twice = (int64_t{1} << 61) / (square >> 30);
  const auto entry = [&](int i, int j, int64_t with_w) {
    const int64_t value = rotation_product(twice, (part[i] * part[j] + with_w) >> 30);
    return static_cast<int32_t>(value - (i == j ? kRotationOne : 0));
  };
  for (int i = 1; i <= 3; ++i) {
    const int j = i == 3 ? 1 : i + 1;
    const int k = i == 1 ? 3 : i - 1;
    rotation[i - 1][i - 1] = entry(i, i, part[0] * part[0]);
    rotation[i - 1][j - 1] = entry(i, j, -part[k] * part[0]);
    rotation[j - 1][i - 1] = entry(i, j, part[k] * part[0]);
  }
}

}  // namespace detail
}  // namespace flashbvh
