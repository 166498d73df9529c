// Making slabs: directions, and how they look from the other tree.
#include "flashbvh/detail/slab.hpp"

namespace flashbvh::detail {
namespace {

constexpr int32_t kHalf = kSplitOne / 2;

/// A direction in the other lattice. The parts of a row's entries are apart, so it is multiplied by
/// both signs.
class Rotate {
 public:
  explicit Rotate(const PackedVector& d)
      : xy_(d.xy),
        negated_xy_(signed_difference(0, d.xy)),
        z_(join_halves(static_cast<uint16_t>(d.z), static_cast<uint16_t>(-d.z))) {}

  int32_t operator()(const SplitRow& row) const {
    return add_signed_products(
               add_signed_products(add_signed_products(kHalf, row.positive_xy, xy_),
                                   row.negative_xy, negated_xy_),
               row.z, z_) >>
           kSplitBits;
  }

 private:
  uint32_t xy_;
  uint32_t negated_xy_;
  uint32_t z_;
};

inline PackedVector rotated(const SplitMatrix& matrix, const PackedVector& d) {
  const Rotate along(d);
  const int32_t x = along(matrix.row[0]);
  const int32_t y = along(matrix.row[1]);
  return {join_halves(static_cast<uint16_t>(x), static_cast<uint16_t>(y)), along(matrix.row[2])};
}

/// Where B's origin lies along a direction in A's lattice, in the direction's unit.
inline int32_t offset_along(const PackedVector& d, const RotatedTransform& transform) {
  const auto product = [&](int32_t x, int i) {
    return static_cast<int64_t>(x) * offset_of(transform.on_a[i]);
  };
  return static_cast<int32_t>((product(d.x(), 0) + product(d.y(), 1) + product(d.z, 2)) >>
                              kSplitBits);
}

/// What rotating a direction with so large a sum of magnitudes can be off by, along it.
inline int32_t margin(const RotatedTransform& transform, Side of, int32_t sum, int32_t reach_b) {
  constexpr int32_t placed = 16712;  // 0.51 * 2^15
  const bool of_a = of == Side::a;
  const uint32_t stretched = of_a ? 0 : static_cast<uint32_t>(reach_b) * transform.matrix->defect;
  const int32_t turned = of_a ? reach_b : (7 * reach_b + 3) >> 2;
  const uint32_t each = static_cast<uint32_t>(turned + placed) + (stretched >> 9);
  return (turned >> 1) +
         static_cast<int32_t>((static_cast<uint64_t>(each) * static_cast<uint32_t>(sum)) >> 15) + 3;
}

}  // namespace

namespace {

/// The sum of the magnitudes.
inline int32_t sum_of(const PackedVector& v) {
  return static_cast<int32_t>(magnitude(v.x()) + magnitude(v.y()) + magnitude(v.z));
}
inline int32_t larger(int32_t u, int32_t v) {
  return u > v ? u : v;
}

}  // namespace

void Slab::rotate(const RotatedTransform& transform, Side of, int32_t reach_b) {
  const bool of_a = of == Side::a;
  const PackedVector own = direction();
  const PackedVector seen = rotated(of_a ? transform.columns : transform.matrix->rows, own);
  const PackedVector& in_a = of_a ? own : seen;
  const int32_t offset = offset_along(in_a, transform);
  set_row(seen, of_a ? -offset : offset,
          margin(transform, of, larger(sum_of(own), sum_of(seen)), reach_b));
}

}  // namespace flashbvh::detail
