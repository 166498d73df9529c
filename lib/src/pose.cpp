// Poses: made, checked, composed, inverted. All in 64-bit integers.
#include "flashbvh/pose.hpp"

namespace flashbvh {
namespace {

/// Fraction bits: of a rotation given, of one kept, of a fraction of a cell, of a defect.
constexpr unsigned kGivenBits = 30;
constexpr unsigned kKeptBits = 22;
constexpr unsigned kCellBits = 16;
constexpr unsigned kDefectBits = 24;
constexpr unsigned kRestBits = kKeptBits - kSplitBits;

constexpr int32_t kOne = 1 << kKeptBits;
constexpr int32_t kTolerance = kRotationTolerance >> (kGivenBits - kKeptBits);
static_assert(kRotationOne == 1 << kGivenBits, "one meaning of one");
static_assert(kTolerance << (kDefectBits - kKeptBits) <= UINT16_MAX,
              "a defect within the tolerance fits its field");

using Entries = int32_t[3][3];

/// Ties go up.
constexpr int64_t shifted_rounded(int64_t value, unsigned bits) {
  return (value + (int64_t{1} << (bits - 1))) >> bits;
}

constexpr int64_t magnitude(int64_t value) {
  return value < 0 ? -value : value;
}

constexpr int64_t product(int32_t u, int32_t v) {
  return static_cast<int64_t>(u) * v;
}

/// A rotation has none beyond 1; below 2, products of three stay in 64 bits.
bool entries_in_range(const Entries& r) {
  for (const auto& row : r) {
    for (const int32_t entry : row) {
      if (entry > kOne + kTolerance || entry < -kOne - kTolerance) {
        return false;
      }
    }
  }
  return true;
}

/// The largest entry of R^T R - 1 and of R R^T - 1, so that a matrix has its inverse's.
[[gnu::noinline]] int64_t defect_of(const Entries& r) {
  int64_t worst = 0;
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k <= j; ++k) {
      const int64_t one = j == k ? product(kOne, kOne) : 0;
      int64_t columns = -one;
      int64_t rows = -one;
      for (int i = 0; i < 3; ++i) {
        columns += product(r[i][j], r[i][k]);
        rows += product(r[j][i], r[k][i]);
      }
      worst = magnitude(columns) > worst ? magnitude(columns) : worst;
      worst = magnitude(rows) > worst ? magnitude(rows) : worst;
    }
  }
  return worst;
}

/// Whether the determinant of an orthogonal matrix is -1 rather than 1. 20 fraction bits are plenty
/// to tell, and six products of three of them stay below 2^63.
[[gnu::noinline]] bool mirrors(const Entries& r) {
  constexpr unsigned drop = kKeptBits - 20;
  int64_t determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    determinant += (r[0][i] >> drop) * (product(r[1][j] >> drop, r[2][k] >> drop) -
                                        product(r[1][k] >> drop, r[2][j] >> drop));
  }
  return determinant < 0;
}

}  // namespace

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                 const int16_t (&fraction)[3]) {
  Pose pose(cells[0], cells[1], cells[2]);
  Entries kept;
  for (int i = 0; i < 3; ++i) {
    pose.fraction_[i] = fraction[i];
    for (int j = 0; j < 3; ++j) {
      kept[i][j] = static_cast<int32_t>(shifted_rounded(rotation[i][j], kGivenBits - kKeptBits));
    }
  }
  pose.set_rotation(kept);
  return pose;
}

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]) {
  return rigid(rotation, cells, {0, 0, 0});
}

[[gnu::noinline]] void Pose::set_rotation(const int32_t (&r)[3][3]) {
  const int64_t worst = entries_in_range(r) ? defect_of(r) : INT64_MAX;
  if (worst > product(kOne, kTolerance) || mirrors(r)) {
    status_ = status_ == Status::done ? Status::not_a_rotation : status_;
    return;
  }
  // With no defect at all, three ones leave room for nothing but zeros.
  turned_ = worst != 0 || r[0][0] != kOne || r[1][1] != kOne || r[2][2] != kOne;
  if (!turned_) {
    return;
  }
  constexpr unsigned shift = 2 * kKeptBits - kDefectBits;
  matrix_.defect = static_cast<uint16_t>((worst + (int64_t{1} << shift) - 1) >> shift);
  int32_t coarse[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      coarse[i][j] = (r[i][j] + (1 << (kRestBits - 1))) >> kRestBits;
      matrix_.rest[i][j] = static_cast<int8_t>(r[i][j] - coarse[i][j] * (1 << kRestBits));
    }
  }
  for (int i = 0; i < 3; ++i) {
    matrix_.rows.row[i] = SplitRow::of(coarse[i][0], coarse[i][1], coarse[i][2]);
    matrix_.columns.row[i] = SplitRow::of(coarse[0][i], coarse[1][i], coarse[2][i]);
  }
}

void Pose::set_translation(int axis, int64_t cells, int64_t fractions) {
  // What the cells have beyond whole ones goes to the fractions.
  const int64_t whole = cells >> kKeptBits;
  const int64_t rest = (cells - whole * kOne) * (1 << kCellBits) + fractions;
  const int64_t part = shifted_rounded(rest, kKeptBits);
  const int64_t carry = shifted_rounded(part, kCellBits);
  if (magnitude(whole + carry) > kMaxTranslation && status_ == Status::done) {
    status_ = Status::translation_out_of_range;
  }
  cells_[axis] = static_cast<int32_t>(whole + carry);
  fraction_[axis] = static_cast<int16_t>(part - carry * (1 << kCellBits));
}

Pose Pose::composed(const Pose& outer, const Pose& inner) {
  Pose pose(0, 0, 0);
  pose.status_ = outer.status_ != Status::done ? outer.status_ : inner.status_;
  if (pose.status_ != Status::done) {
    return pose;
  }
  Entries rotation;
  for (int i = 0; i < 3; ++i) {
    // Whole cells and fractions apart: together they would take more than 64 bits.
    int64_t whole = product(outer.cells_[i], kOne);
    int64_t part = product(outer.fraction_[i], kOne);
    for (int k = 0; k < 3; ++k) {
      whole += product(outer.fine(i, k), inner.cells_[k]);
      part += product(outer.fine(i, k), inner.fraction_[k]);
      int64_t sum = 0;
      for (int j = 0; j < 3; ++j) {
        sum += product(outer.fine(i, j), inner.fine(j, k));
      }
      rotation[i][k] = static_cast<int32_t>(shifted_rounded(sum, kKeptBits));
    }
    pose.set_translation(i, whole, part);
  }
  pose.set_rotation(rotation);
  return pose;
}

Pose Pose::inverse() const {
  Pose back(0, 0, 0);
  back.status_ = status_;
  if (status_ != Status::done) {
    return back;
  }
  Entries transposed;
  for (int i = 0; i < 3; ++i) {
    int64_t whole = 0;
    int64_t part = 0;
    for (int k = 0; k < 3; ++k) {
      transposed[i][k] = fine(k, i);
      whole -= product(fine(k, i), cells_[k]);
      part -= product(fine(k, i), fraction_[k]);
    }
    back.set_translation(i, whole, part);
  }
  back.set_rotation(transposed);
  return back;
}

}  // namespace flashbvh
