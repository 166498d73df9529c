// Makes, checks, composes and inverts poses, in integers with 64-bit products.
#include "flashbvh/pose.hpp"

namespace flashbvh {
namespace {

using detail::kDefectBits;

/// Fraction bits of a given rotation, of a stored rotation and of a fraction of a cell.
constexpr unsigned kGivenBits = 30;
constexpr unsigned kKeptBits = detail::kRotationBits;
constexpr unsigned kCellBits = 16;

constexpr int32_t kOne = 1 << kKeptBits;
constexpr int32_t kTolerance = kRotationTolerance >> (kGivenBits - kKeptBits);
static_assert(kRotationOne == 1 << kGivenBits, "one meaning of one");

/// The tolerance, in 2^-kDefectBits.
constexpr uint32_t kMaxEntryDefect = static_cast<uint32_t>(kTolerance) << (kDefectBits - kKeptBits);

/// Rounding moves each entry of a product by up to 2^-23; F is the matrix of these errors, with a
/// norm of at most 3 * 2^-23. It adds F^T A B and its transpose to (AB + F)^T (AB + F) - 1. Their
/// norm is 6 * 2^-23 times those of A and B, which the tolerance keeps below 1 + 2^-11.
constexpr uint32_t kRoundingDefect = 13;
static_assert(kRoundingDefect > (6 << kDefectBits >> 23), "6 * 2^-23 and a little");
/// Only many products or coarse matrices exceed this sum of two defects: a margin of 3/4 cell at
/// most on the largest lattice.
constexpr uint32_t kMaxSummedDefect = 1 << (kDefectBits - 16);

using Entries = int32_t[3][3];

/// Drops `bits` fraction bits; ties go up.
constexpr int64_t shifted_rounded(int64_t value, unsigned bits) {
  return (value + (int64_t{1} << (bits - 1))) >> bits;
}

constexpr int64_t magnitude(int64_t value) {
  return value < 0 ? -value : value;
}

constexpr int64_t long_product(int32_t u, int32_t v) {
  return static_cast<int64_t>(u) * v;
}

[[gnu::noinline]] int64_t dot(const int32_t (&u)[3], const int32_t (&v)[3]) {
  return long_product(u[0], v[0]) + long_product(u[1], v[1]) + long_product(u[2], v[2]);
}

/// The magnitude of an entry of R^T R - 1, in 2^-kDefectBits, rounded up. Given entries are below
/// 2, so it is below 2^28.
[[gnu::noinline]] uint32_t deviation(const Entries& r, int j, int k) {
  const int64_t one = j == k ? long_product(kOne, kOne) : 0;
  const int64_t square = magnitude(long_product(r[0][j], r[0][k]) + long_product(r[1][j], r[1][k]) +
                                   long_product(r[2][j], r[2][k]) - one);
  constexpr unsigned drop = 2 * kKeptBits - kDefectBits;  // a product has twice the fraction bits
  return static_cast<uint32_t>((square + (int64_t{1} << drop) - 1) >> drop);
}

/// Returns whether an orthogonal matrix has the determinant -1, not 1: each cofactor is then minus
/// its entry. One entry of a row is at least 0.57 in magnitude, so signs decide.
inline bool mirrors(const Entries& r) {
  const int32_t sizes[2] = {r[0][0] < 0 ? -r[0][0] : r[0][0], r[0][1] < 0 ? -r[0][1] : r[0][1]};
  constexpr int32_t half = kOne / 2;
  const int i = sizes[0] >= half ? 0 : sizes[1] >= half ? 1 : 2;
  const int j = i == 2 ? 0 : i + 1;
  const int k = i == 0 ? 2 : i - 1;
  const int64_t cofactor = long_product(r[1][j], r[2][k]) - long_product(r[1][k], r[2][j]);
  return (cofactor < 0) != (r[0][i] < 0);
}

constexpr uint32_t kNoRotation = UINT32_MAX;

/// Upper bound on the spectral norm of R^T R - 1, in 2^-kDefectBits: the largest sum of a row's
/// magnitudes, as the matrix is symmetric. kNoRotation if an entry is beyond the tolerance.
[[gnu::noinline]] uint32_t defect_of(const Entries& r) {
  const auto greater = [](uint32_t u, uint32_t v) { return u > v ? u : v; };
  const uint32_t xy = deviation(r, 0, 1);
  const uint32_t xz = deviation(r, 0, 2);
  const uint32_t yz = deviation(r, 1, 2);
  const uint32_t x = deviation(r, 0, 0);
  const uint32_t y = deviation(r, 1, 1);
  const uint32_t z = deviation(r, 2, 2);
  if (greater(greater(x, greater(y, z)), greater(xy, greater(xz, yz))) > kMaxEntryDefect) {
    return kNoRotation;
  }
  return greater(x + xy + xz, greater(y + xy + yz, z + xz + yz));
}

/// Returns whether R is exactly the identity.
inline bool is_identity(const Entries& r) {
  return ((r[0][0] ^ kOne) | (r[1][1] ^ kOne) | (r[2][2] ^ kOne) | r[0][1] | r[0][2] | r[1][0] |
          r[1][2] | r[2][0] | r[2][1]) == 0;
}

/// Rounds a given entry to kKeptBits in 32-bit arithmetic; halves go up.
constexpr int32_t kept_of(int32_t given) {
  return ((given >> (kGivenBits - kKeptBits - 1)) + 1) >> 1;
}

}  // namespace

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                 const int16_t (&fraction)[3]) {
  Pose pose(cells[0], cells[1], cells[2]);
  Entries kept;
  for (int i = 0; i < 3; ++i) {
    pose.fraction_[i] = fraction[i];
    kept[i][0] = kept_of(rotation[i][0]);
    kept[i][1] = kept_of(rotation[i][1]);
    kept[i][2] = kept_of(rotation[i][2]);
  }
  pose.set_rotation(kept, defect_of(kept));
  return pose;
}

Pose Pose::rigid(const int32_t (&rotation)[3][3], const int32_t (&cells)[3]) {
  return rigid(rotation, cells, {0, 0, 0});
}

[[gnu::noinline]] void Pose::set_rotation(const Entries& r, uint32_t defect) {
  if (defect == kNoRotation || mirrors(r)) {
    refuse(Status::not_a_rotation);
    return;
  }
  rotated_ = !is_identity(r);
  if (!rotated_) {
    return;
  }
  matrix_.defect = static_cast<uint16_t>(defect);
  for (int i = 0; i < 3; ++i) {
    int32_t coarse[3];
    for (int j = 0; j < 3; ++j) {
      coarse[j] = (r[i][j] + (1 << (detail::kRestBits - 1))) >> detail::kRestBits;
      matrix_.rest[i][j] = static_cast<int8_t>(r[i][j] - coarse[j] * (1 << detail::kRestBits));
    }
    matrix_.rows.row[i] = detail::SplitRow::of(coarse[0], coarse[1], coarse[2]);
  }
}

[[gnu::noinline]] void Pose::get_rotation(Entries& r) const {
  for (int i = 0; i < 3; ++i) {
    if (rotated_) {
      matrix_.get_row(i, r[i][0], r[i][1], r[i][2]);
    } else {
      r[i][0] = r[i][1] = r[i][2] = 0;
      r[i][i] = kOne;
    }
  }
}

[[gnu::noinline]] void Pose::get_transposed(Entries& r) const {
  get_rotation(r);
  const auto swap = [](int32_t& u, int32_t& v) {
    const int32_t kept = u;
    u = v;
    v = kept;
  };
  swap(r[0][1], r[1][0]);
  swap(r[0][2], r[2][0]);
  swap(r[1][2], r[2][1]);
}

[[gnu::noinline]] void Pose::set_product(const Entries& left, const Entries& right,
                                         uint32_t defects) {
  Entries entries;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const int64_t sum = dot(left[i], right[k]);
      entries[i][k] = static_cast<int32_t>(shifted_rounded(sum, kKeptBits));
    }
  }
  defects += kRoundingDefect;
  set_rotation(entries, defects > kMaxSummedDefect ? defect_of(entries) : defects);
}

[[gnu::noinline]] void Pose::set_translation(const Entries& left, const int32_t (&cells)[3],
                                             const int32_t (&fraction)[3], const Pose* added_to) {
  for (int i = 0; i < 3; ++i) {
    // Whole cells and fractions are summed apart: together they would take more than 64 bits.
    int64_t whole = dot(left[i], cells);
    int64_t part = dot(left[i], fraction);
    if (added_to != nullptr) {
      whole += long_product(added_to->cells_[i], kOne);
      part += long_product(added_to->fraction_[i], kOne);
    }
    // Adds the fraction bits of the cells' sum to the fractions.
    part += (whole & (kOne - 1)) * (1 << kCellBits);
    const int64_t fine_part = shifted_rounded(part, kKeptBits);
    const int64_t carry = shifted_rounded(fine_part, kCellBits);
    whole = (whole >> kKeptBits) + carry;
    if (magnitude(whole) > kMaxTranslation) {
      refuse(Status::translation_out_of_range);
    }
    cells_[i] = static_cast<int32_t>(whole);
    fraction_[i] = static_cast<int16_t>(fine_part - carry * (1 << kCellBits));
  }
}

Pose Pose::composed(const Pose& outer, const Pose& inner) {
  Pose pose(0, 0, 0);
  pose.status_ = outer.status_ != Status::done ? outer.status_ : inner.status_;
  if (pose.status_ != Status::done) {
    return pose;
  }
  Entries left;
  Entries right;
  outer.get_rotation(left);
  inner.get_transposed(right);
  const int32_t fraction[3] = {inner.fraction_[0], inner.fraction_[1], inner.fraction_[2]};
  pose.set_translation(left, inner.cells_, fraction, &outer);
  pose.set_product(left, right, outer.defect() + inner.defect());
  return pose;
}

Pose Pose::relative(const Pose& world_a, const Pose& world_b) {
  Pose pose(0, 0, 0);
  pose.status_ = world_a.status_ != Status::done ? world_a.status_ : world_b.status_;
  if (pose.status_ != Status::done) {
    return pose;
  }
  Entries left;
  Entries right;
  world_a.get_transposed(left);
  world_b.get_transposed(right);
  int32_t cells[3];
  int32_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = world_b.cells_[i] - world_a.cells_[i];
    fraction[i] = world_b.fraction_[i] - world_a.fraction_[i];
  }
  pose.set_translation(left, cells, fraction, nullptr);
  pose.set_product(left, right, world_a.defect() + world_b.defect());
  return pose;
}

Pose Pose::inverse() const {
  Pose back(0, 0, 0);
  back.status_ = status_;
  if (status_ != Status::done) {
    return back;
  }
  Entries left;
  get_transposed(left);
  const int32_t cells[3] = {-cells_[0], -cells_[1], -cells_[2]};
  const int32_t fraction[3] = {-fraction_[0], -fraction_[1], -fraction_[2]};
  back.set_translation(left, cells, fraction, nullptr);
  back.set_rotation(left, defect());
  return back;
}

}  // namespace flashbvh
