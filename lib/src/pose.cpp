// Poses: made, checked, composed, inverted. All in 64-bit integers.
#include "flashbvh/pose.hpp"

namespace flashbvh {
namespace {

/// Entries up to this keep every sum of three products below 2^63. A rotation's are at most 1.
constexpr int32_t kMostEntry = kRotationOne + kRotationTolerance;

constexpr unsigned kRotationBits = 30;
constexpr unsigned kFractionBits = 16;
constexpr unsigned kDefectBits = 24;

static_assert(kRotationOne == 1 << kRotationBits, "one meaning of one");
static_assert((kRotationTolerance >> (kRotationBits - kDefectBits)) <= UINT16_MAX,
              "a defect within the tolerance fits its field");

/// Halves away from minus infinity: ties go up.
constexpr int64_t shifted_rounded(int64_t value, unsigned bits) {
  return (value + (int64_t{1} << (bits - 1))) >> bits;
}

constexpr int64_t magnitude(int64_t value) {
  return value < 0 ? -value : value;
}

int64_t product(int32_t u, int32_t v) {
  return static_cast<int64_t>(u) * v;
}

using Matrix = int32_t[3][3];

bool entries_in_range(const Matrix& r) {
  for (const auto& row : r) {
    for (const int32_t entry : row) {
      if (magnitude(entry) > kMostEntry) {
        return false;
      }
    }
  }
  return true;
}

/// The largest entry of R^T R - 1 and of R R^T - 1, so that a matrix has its inverse's; 60 fraction
/// bits.
int64_t defect_of(const Matrix& r) {
  int64_t worst = 0;
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k <= j; ++k) {
      const int64_t one = j == k ? product(kRotationOne, kRotationOne) : 0;
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
/// to tell, and six products of three keep below 2^63.
bool mirrors(const Matrix& r) {
  int64_t determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    determinant += (r[0][i] >> 10) *
                   (product(r[1][j] >> 10, r[2][k] >> 10) - product(r[1][k] >> 10, r[2][j] >> 10));
  }
  return determinant < 0;
}

}  // namespace

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                 const int16_t (&fraction)[3]) {
  Pose pose(cells[0], cells[1], cells[2]);
  for (int row = 0; row < 3; ++row) {
    pose.fraction_[row] = fraction[row];
    for (int column = 0; column < 3; ++column) {
      pose.rotation_[row][column] = rotation[row][column];
    }
  }
  pose.check_rotation();
  return pose;
}

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]) {
  return rigid(rotation, cells, {0, 0, 0});
}

/// Leaves `status_` alone if the matrix is a rotation; sets `turned_` and `defect_`.
void Pose::check_rotation() {
  const Matrix& r = rotation_;
  if (!entries_in_range(r)) {
    status_ = Status::not_a_rotation;
    return;
  }
  const int64_t worst = defect_of(r);
  if (worst > product(kRotationOne, kRotationTolerance) || mirrors(r)) {
    status_ = Status::not_a_rotation;
    return;
  }
  constexpr unsigned shift = 2 * kRotationBits - kDefectBits;
  defect_ = static_cast<uint16_t>((worst + (int64_t{1} << shift) - 1) >> shift);
  // With no defect at all, three ones leave room for nothing but zeros.
  turned_ =
      worst != 0 || r[0][0] != kRotationOne || r[1][1] != kRotationOne || r[2][2] != kRotationOne;
}

void Pose::set_translation(int axis, int64_t t) {
  const int64_t cells = shifted_rounded(t, kRotationBits);
  if (magnitude(cells) > kMaxTranslation && status_ == Status::done) {
    status_ = Status::translation_out_of_range;
  }
  cells_[axis] = static_cast<int32_t>(cells);
  // Less than half a cell may round up to a whole one; the largest fraction is as near.
  const int64_t rest = shifted_rounded(t - cells * kRotationOne, kRotationBits - kFractionBits);
  fraction_[axis] = static_cast<int16_t>(rest > INT16_MAX ? INT16_MAX : rest);
}

Pose Pose::composed(const Pose& outer, const Pose& inner) {
  Pose pose(0, 0, 0);
  pose.status_ = outer.status_ != Status::done ? outer.status_ : inner.status_;
  if (pose.status_ != Status::done) {
    return pose;
  }
  for (int i = 0; i < 3; ++i) {
    // 30 fraction bits; below 2^61, since both translations are below 2^29.
    int64_t t = product(outer.cells_[i], kRotationOne) +
                product(outer.fraction_[i], kRotationOne >> kFractionBits);
    for (int k = 0; k < 3; ++k) {
      t += product(outer.rotation_[i][k], inner.cells_[k]) +
           shifted_rounded(product(outer.rotation_[i][k], inner.fraction_[k]), kFractionBits);
      int64_t sum = 0;
      for (int j = 0; j < 3; ++j) {
        sum += product(outer.rotation_[i][j], inner.rotation_[j][k]);
      }
      pose.rotation_[i][k] = static_cast<int32_t>(shifted_rounded(sum, kRotationBits));
    }
    pose.set_translation(i, t);
  }
  pose.check_rotation();
  return pose;
}

Pose Pose::inverse() const {
  Pose turned(0, 0, 0);
  Pose moved(0, 0, 0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      turned.rotation_[i][j] = rotation_[j][i];
    }
    moved.cells_[i] = -cells_[i];
    // The fraction -32,768 has no negative: half a cell up is the next cell's.
    moved.fraction_[i] =
        static_cast<int16_t>(fraction_[i] == INT16_MIN ? INT16_MIN : -fraction_[i]);
    moved.cells_[i] += fraction_[i] == INT16_MIN ? 1 : 0;
  }
  turned.status_ = status_;
  turned.turned_ = turned_;
  return composed(turned, moved);
}

}  // namespace flashbvh
