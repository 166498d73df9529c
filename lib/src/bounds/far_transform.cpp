// Places a B that lies kMaxOffset cells off or farther, for distance predicates.
#include "flashbvh/detail/bounds/transform.hpp"

namespace flashbvh::detail {
namespace {

/// Identity for a B that is only translated, so that one code path serves both.
constexpr RotationMatrix kUnrotated = {
    {{SplitRow::of(kSplitOne, 0, 0), SplitRow::of(0, kSplitOne, 0), SplitRow::of(0, 0, kSplitOne)}},
    {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    0};

/// Error of keeping 14 of a rotation's 22 bits, on the largest lattice, and of vertices' rounding.
constexpr int32_t kMargin = 3 * kMaxCoordinate / 2 + 1 + kSplitOne / 2;

}  // namespace

void Transform::place_far(const Pose& pose, const int32_t (&origin_a)[3],
                          const int32_t (&origin_b)[3]) noexcept {
  const bool rotates = !pose.is_translation();
  const RotationMatrix& matrix = rotates ? pose.matrix() : kUnrotated;
  constexpr int64_t most = int64_t{kMaxFarOffset} * kSplitOne;
  placing_ = Placing::far_off;
  rotated_.matrix = &matrix;
  if (!rotates) {
    rotated_.columns = matrix.rows;
  }
  int32_t whole[3];
  for (int i = 0; i < 3; ++i) {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;
    matrix.get_row(i, x, y, z);
    const int64_t cells = int64_t{pose.translation(i)} - origin_a[i];
    const int32_t fraction = rotates ? pose.fraction(i) * (1 << (kRotationBits - 16)) : 0;
    // Rounded as near offsets are (rotated_transform.cpp); below 2^55.
    const int64_t sum = fraction + (1 << (kRestBits - 1)) + int64_t{x} * origin_b[0] +
                        int64_t{y} * origin_b[1] + int64_t{z} * origin_b[2] +
                        cells * (1 << kRotationBits);
    int64_t offset = sum >> kRestBits;
    if (offset >= most || offset <= -most) {
      placing_ = Placing::beyond;
      offset = offset < 0 ? -most : most;
    }
    whole[i] = static_cast<int32_t>((offset + kSplitOne / 2) >> kSplitBits);
    const auto rest = static_cast<int32_t>(offset - int64_t{whole[i]} * kSplitOne);
    const int32_t bias = (kSplitOne - matrix.rows.row[i].sum()) * kBoundBias + kMargin;
    rotated_.on_a[i] = {bias + rest, bias - rest};
    rotated_.on_b[i] = {0, 0};
  }
  rotated_.far_offset = {whole[0], whole[1], whole[2]};
}

void move(const Point& by, Triangle& triangle) noexcept {
  for (Point& corner : triangle.corner) {
    corner = {corner.x + by.x, corner.y + by.y, corner.z + by.z};
  }
}

}  // namespace flashbvh::detail
