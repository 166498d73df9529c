// Rotates the directions of slabs into the other tree's lattice.
#include "flashbvh/detail/bounds/slab.hpp"

namespace flashbvh::detail {
namespace {

constexpr int32_t kHalfUnit = kSplitOne / 2;

/// Rotates a direction into the other lattice. Rows store positive and negative parts of entries
/// apart, so the direction is kept with both signs.
class Rotate {
 public:
  explicit Rotate(const PackedVector& d)
      : xy_(d.xy),
        negated_xy_(signed_difference(0, d.xy)),
        z_(join_halves(static_cast<uint16_t>(d.z), static_cast<uint16_t>(-d.z))) {}

  int32_t operator()(const SplitRow& row) const {
    return add_signed_products(
               add_signed_products(add_signed_products(kHalfUnit, row.positive_xy, xy_),
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

/// B's origin along a direction in A's lattice, with coordinates rounded to whole cells.
inline int32_t origin_along(const PackedVector& d, const RotatedTransform& transform) {
  const auto cells = [&](int i) {
    const BoxTestStart& start = transform.on_a[i];
    return (start.upper - start.lower + kSplitOne) >> (kSplitBits + 1);
  };
  return d.x() * cells(0) + d.y() * cells(1) + d.z * cells(2);
}

}  // namespace

void Slab::rotate(const Transform& transform, Side of) {
  const RotatedTransform& rotation = transform.rotated();
  const bool of_a = of == Side::a;
  const PackedVector own = direction();
  const PackedVector seen = rotated(of_a ? rotation.columns : rotation.matrix->rows, own);
  const int32_t along = origin_along(of_a ? own : seen, rotation);
  set_row(seen, of_a ? -along : along, transform.slab_margin());
}

}  // namespace flashbvh::detail
