// Prepares a rotated transform, and transforms vertices.
#include "flashbvh/detail/bounds/rotated_transform.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"

// Tests one axis after another, up to the first that separates; with vectors all three at once.
#if defined(FLASHBVH_ROTATE_SSE2)
#include "../arch/sse2/starts.hpp"
#define FLASHBVH_ONE_AXIS inline
#elif UINTPTR_MAX == UINT32_MAX && !defined(__thumb2__) && !defined(__OPTIMIZE_SIZE__) && \
    !defined(FLASHBVH_PORTABLE)
// A 64-bit product takes several instructions, or a call; a product of two halves takes two.
#include "../arch/plain/sums.hpp"
#define FLASHBVH_NARROW_SUMS 1
#define FLASHBVH_ONE_AXIS [[gnu::noinline]]
#else
#define FLASHBVH_ONE_AXIS [[gnu::noinline]]
#endif

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

constexpr int32_t kHalf = kSplitOne / 2;

inline int32_t clamp_offset(int64_t offset) {
  constexpr int32_t most = kMaxOffset * kSplitOne;
#if defined(FLASHBVH_ROTATE_SSE2)
  return static_cast<int32_t>(offset < -most ? -most : offset > most ? most : offset);
#else
  const auto low = static_cast<int32_t>(offset);
  const auto high = static_cast<int32_t>(offset >> 32);
  const bool within = high == low >> 31 && static_cast<uint32_t>(low) + most <= 2u * most;
  return within ? low : high < 0 ? -most : most;
#endif
}

inline int64_t product(int32_t u, int32_t v) {
  return static_cast<int64_t>(u) * v;
}

/// The pose's translation from A's origin; wraps if the pose is out of range, which is its error.
inline int32_t cells_along_axis(const Pose& pose, const int32_t (&origin_a)[3], int axis) {
  return static_cast<int32_t>(static_cast<uint32_t>(pose.translation(axis)) -
                              static_cast<uint32_t>(origin_a[axis]));
}

/// Returns the place of B's origin along an axis of A's lattice; kSplitOne is a cell.
FLASHBVH_ONE_AXIS int32_t offset_along_axis(const Pose& pose, const int32_t (&origin_a)[3],
                                            const int32_t (&origin_b)[3], int axis) {
  const int32_t cells = cells_along_axis(pose, origin_a, axis);
  int32_t x = 0;
  int32_t y = 0;
  int32_t z = 0;
  pose.matrix().get_row(axis, x, y, z);
  // kRotationBits fraction bits; below 2^54.
  const int32_t fraction = pose.fraction(axis) * (1 << (kRotationBits - 16));
  const int64_t sum = fraction + (1 << (kRestBits - 1)) + product(x, origin_b[0]) +
                      product(y, origin_b[1]) + product(z, origin_b[2]) +
                      product(cells, 1 << kRotationBits);
  // The high word mostly shows that the sum is within range.
  constexpr int32_t most = kMaxOffset * kSplitOne >> (32 - kRestBits);
  const auto high = static_cast<int32_t>(sum >> 32);
  if (static_cast<uint32_t>(high + most) < 2u * most) {
    return static_cast<int32_t>(sum >> kRestBits);
  }
  return clamp_offset(sum >> kRestBits);
}

#if defined(FLASHBVH_NARROW_SUMS)

/// True if the coordinates fit 16 bits.
inline bool is_near(const int32_t (&origin)[3]) {
  constexpr uint32_t half = 1u << 15;
  const auto raised = [&](int axis) { return static_cast<uint32_t>(origin[axis]) + half; };
  return (raised(0) | raised(1) | raised(2)) < 2 * half;
}

/// offset_along_axis() for a B whose origin is near. Coarse entries and the remaining bits are
/// summed apart; the sum in whole cells decides about clamping.
inline int32_t near_offset_along_axis(const Pose& pose, const int32_t (&origin_a)[3],
                                      const int32_t (&origin_b)[3], int axis) {
  const int32_t cells = cells_along_axis(pose, origin_a, axis);
  const SplitRow& row = pose.matrix().rows.row[axis];
  const int8_t(&rest)[3] = pose.matrix().rest[axis];
  // Both entries in a word; the second one is less by 1 if the first one is negative.
  const uint32_t xy = row.positive_xy - row.negative_xy;
  const auto x = static_cast<int16_t>(xy);
  const int32_t y = static_cast<int32_t>(xy - static_cast<uint32_t>(x)) >> 16;
  const int32_t z = row.z_entry();
  const int32_t fraction = pose.fraction(axis) * (1 << (kRotationBits - 16));
  const int32_t parts = fraction + (1 << (kRestBits - 1)) + rest[0] * origin_b[0] +
                        rest[1] * origin_b[1] + rest[2] * origin_b[2];
  const int32_t turned = x * origin_b[0] + y * origin_b[1] + z * origin_b[2] + (parts >> kRestBits);
  const auto whole = static_cast<int32_t>(static_cast<uint32_t>(turned >> kSplitBits) +
                                          static_cast<uint32_t>(cells));
  if (static_cast<uint32_t>(whole) + kMaxOffset < 2u * kMaxOffset) {
    return static_cast<int32_t>(static_cast<uint32_t>(turned) +
                                static_cast<uint32_t>(cells) * kSplitOne);
  }
  return whole < 0 ? -kMaxOffset * kSplitOne : kMaxOffset * kSplitOne;
}

#endif

/// A bound on the difference between the rotations of B's boxes and of its vertices.
int32_t box_margin(const RotationMatrix& matrix, int32_t reach_b) {
  const int8_t* const rest = matrix.rest[0];
  int32_t most = 0;
  for (int i = 0; i < 9; ++i) {
    const int32_t size = rest[i] < 0 ? -rest[i] : rest[i];
    most = size > most ? size : most;
  }
  return ((most * reach_b) >> kRestBits) + 1;
}

/// A bound on the error of a transformed vertex along one of B's axes: lib/docs/derivations.md,
/// "Rotated boxes".
int32_t axis_margin(const RotationMatrix& matrix, int32_t reach_b) {
  const uint32_t stretched = static_cast<uint32_t>(reach_b) * matrix.defect;
  return 7 * (kSplitOne / 8) + ((7 * reach_b) >> 3) + static_cast<int32_t>(stretched >> 10) + 4;
}

/// The start of a sum whose products have biased bounds, and which is a biased bound.
BoxTestStart start_of(const SplitRow& row, int32_t offset, int32_t margin) {
  const int32_t bias = (kSplitOne - row.sum()) * kBoundBias;
  return {bias + margin + offset, bias + margin - offset};
}

/// The largest box_margin(), for 14 bits in place of 22, and the rounding of vertices.
constexpr int32_t kWidestMargin = 3 * kMaxCoordinate / 2 + 1 + kHalf;

/// True if a root box, rotated, and the other root box are disjoint along an axis of the latter.
FLASHBVH_INLINE_FOR_SPEED inline bool far_apart(const SplitRow& row, const BoxTestStart& start,
                                                const PackedBox& rotated, const PackedBox& other,
                                                int axis) {
  using Half [[gnu::may_alias]] = uint16_t;
  const Half* const bounds = reinterpret_cast<const Half*>(&other) + (axis == 2 ? 4 : axis);
  const int32_t upper = bounds[0];
  const int32_t lower = bounds[axis == 2 ? 1 : 2];
#if defined(FLASHBVH_NARROW_SUMS)
  const AxisBounds x = {loaded_half(rotated.upper_xy, 0), loaded_half(rotated.lower_xy, 0)};
  const AxisBounds y = {loaded_half(rotated.upper_xy, 1), loaded_half(rotated.lower_xy, 1)};
  const AxisBounds z = {loaded_half(rotated.z, 0), loaded_half(rotated.z, 1)};
  const AxisSums sums = rotated_sums(row, start, x, y, z);
  const auto most = static_cast<int32_t>(sums.upper);
  const auto least = static_cast<int32_t>(sums.lower);
#else
  const int32_t most =
      add_products(add_products(add_products(start.upper, row.positive_xy, rotated.upper_xy),
                                row.negative_xy, rotated.lower_xy),
                   row.z, rotated.z);
  const int32_t least = add_crossed_products(
      add_products(add_products(start.lower, row.positive_xy, rotated.lower_xy), row.negative_xy,
                   rotated.upper_xy),
      row.z, rotated.z);
#endif
  return (most >> kSplitBits) + lower < 2 * kBoundBias ||
         (least >> kSplitBits) + upper < 2 * kBoundBias;
}

#if !defined(FLASHBVH_ROTATE_SSE2)
/// The axis along which B lies farthest from A: most often it separates the roots.
FLASHBVH_INLINE_FOR_SPEED inline int farthest_axis(const Pose& pose, const int32_t (&origin_a)[3]) {
  const auto size = [&](int axis) {
    const int32_t cells = cells_along_axis(pose, origin_a, axis);
    return static_cast<uint32_t>(cells ^ (cells >> 31));
  };
  const uint32_t x = size(0);
  const uint32_t y = size(1);
  const uint32_t z = size(2);
  const int of_xy = x >= y ? 0 : 1;
  return z > (x >= y ? x : y) ? 2 : of_xy;
}
#endif

/// Computes one coordinate of transformed vertices.
class Row {
 public:
  Row(const RotatedTransform& transform, int axis) {
    const SplitRow& row = transform.matrix->rows.row[axis];
    const int8_t(&rest)[3] = transform.matrix->rest[axis];
    entries_ = {signed_difference(row.positive_xy, row.negative_xy), row.z_entry()};
    rest_ = {join_halves(static_cast<uint32_t>(rest[0]) & 0xFFFFu, static_cast<uint32_t>(rest[1])),
             rest[2]};
    offset_ = offset_of(transform.on_a[axis]) + kHalf;
  }

  int32_t transform(const PackedVector& v) const {
    const int32_t rest = add_signed_products(rest_.z * v.z, rest_.xy, v.xy);
    const int32_t sum = add_signed_products(entries_.z * v.z + offset_, entries_.xy, v.xy);
    return (sum + (rest >> kRestBits)) >> kSplitBits;
  }

 private:
  PackedVector entries_;
  PackedVector rest_;
  int32_t offset_;
};

}  // namespace

bool RotatedTransform::prepare(const Pose& pose, const int32_t (&origin_a)[3],
                               const PackedBox& root_a, const int32_t (&origin_b)[3],
                               const PackedBox& root_b, bool may_stop) {
  matrix = &pose.matrix();
#if defined(FLASHBVH_ROTATE_SSE2)
  const RowLanes rows = row_lanes(matrix->rows);
  const auto along = [&](int axis) { return offset_along_axis(pose, origin_a, origin_b, axis); };
  const int32_t offset[3] = {along(0), along(1), along(2)};
  const BoxTestLanes starts = start_all(rows, offset, kWidestMargin);
  if (may_stop && far_apart(rows, starts, root_a, root_b)) {
    return false;
  }
  store_all(starts, on_a);
#else
#if defined(FLASHBVH_NARROW_SUMS)
  const bool b_is_near = is_near(origin_b);
  const auto offset_along = [&](int axis) {
    return b_is_near ? near_offset_along_axis(pose, origin_a, origin_b, axis)
                     : offset_along_axis(pose, origin_a, origin_b, axis);
  };
#else
  const auto offset_along = [&](int axis) {
    return offset_along_axis(pose, origin_a, origin_b, axis);
  };
#endif
  int axis = farthest_axis(pose, origin_a);
  for (int i = 0; i < 3; ++i) {
    const SplitRow& row = matrix->rows.row[axis];
    on_a[axis] = start_of(row, offset_along(axis), kWidestMargin);
    if (may_stop && far_apart(row, on_a[axis], root_b, root_a, axis)) {
      return false;
    }
    axis = axis == 2 ? 0 : axis + 1;
  }
#endif
  return prepare_boxes(root_a, root_b, may_stop);
}

bool RotatedTransform::prepare_boxes(const PackedBox& root_a, const PackedBox& root_b,
                                     bool may_stop) {
  const int32_t reach_b = reach(root_b);
  const int32_t margin = axis_margin(*matrix, reach_b);
  const int32_t offset[3] = {offset_of(on_a[0]), offset_of(on_a[1]), offset_of(on_a[2])};
  for (int axis = 0; axis < 3; ++axis) {
    columns.row[axis] = matrix->rows.column(axis);
    const SplitRow& column = columns.row[axis];
    const int64_t back = product(column.x(), offset[0]) + product(column.y(), offset[1]) +
                         product(column.z_entry(), offset[2]);
    on_b[axis] = start_of(column, clamp_offset(-(back >> kSplitBits)), margin);
    if (may_stop && far_apart(column, on_b[axis], root_a, root_b, axis)) {
      return false;
    }
  }
  const int32_t narrower = kWidestMargin - (box_margin(*matrix, reach_b) + kHalf);
  for (BoxTestStart& start : on_a) {
    start.upper -= narrower;
    start.lower -= narrower;
  }
  return true;
}

Point RotatedTransform::transform(const Vertex& v) const {
  PackedVector p = PackedVector::of(v);
  return {Row(*this, 0).transform(p), Row(*this, 1).transform(p), Row(*this, 2).transform(p)};
}

void RotatedTransform::transform(const Vertex& u, const Vertex& v, const Vertex& w,
                                 Triangle& triangle) const {
  PackedVector p = PackedVector::of(u);
  PackedVector q = PackedVector::of(v);
  PackedVector r = PackedVector::of(w);
  const auto transform_axis = [&](int axis, int32_t Point::*coordinate) {
    const Row row(*this, axis);
    triangle.corner[0].*coordinate = row.transform(p);
    triangle.corner[1].*coordinate = row.transform(q);
    triangle.corner[2].*coordinate = row.transform(r);
  };
  transform_axis(0, &Point::x);
  transform_axis(1, &Point::y);
  transform_axis(2, &Point::z);
}

}  // namespace flashbvh::detail
