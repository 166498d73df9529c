// Making slabs: directions, and how they look from the other tree.
#include "flashbvh/detail/slab.hpp"

namespace flashbvh::detail {
namespace {

inline uint32_t magnitude(int32_t x) {
  return x < 0 ? 0u - static_cast<uint32_t>(x) : static_cast<uint32_t>(x);
}

/// To kDirectionBits; false if all components are 0.
bool scale(Direction& d) {
  const uint32_t all = magnitude(d.x) | magnitude(d.y) | magnitude(d.z);
  if (all == 0) {
    return false;
  }
  const int up = __builtin_clz(all) - static_cast<int>(32 - kDirectionBits);
  if (up >= 0) {
    d = {static_cast<int32_t>(static_cast<uint32_t>(d.x) << up),
         static_cast<int32_t>(static_cast<uint32_t>(d.y) << up),
         static_cast<int32_t>(static_cast<uint32_t>(d.z) << up)};
  } else {
    d = {d.x >> -up, d.y >> -up, d.z >> -up};
  }
  return true;
}

struct Edge {
  int32_t x;
  int32_t y;
  int32_t z;
};
inline Edge edge(const Vertex& from, const Vertex& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

constexpr int32_t kHalf = kSplitOne / 2;

/// A component in the other lattice.
inline int32_t rotate(const SplitRow& row, const Direction& d) {
  return (row.x() * d.x + row.y() * d.y + row.z_entry() * d.z + kHalf) >> kSplitBits;
}
inline Direction rotate(const SplitMatrix& matrix, const Direction& d) {
  return {rotate(matrix.row[0], d), rotate(matrix.row[1], d), rotate(matrix.row[2], d)};
}

/// Where B's origin lies along a direction in A's lattice, in the direction's unit.
inline int32_t offset_along(const Direction& d, const RotatedTransform& transform) {
  const auto product = [&](int32_t x, int i) {
    return static_cast<int64_t>(x) *
           ((transform.on_a[i].upper - transform.on_a[i].lower) / 2);  // exact: see start_of()
  };
  return static_cast<int32_t>((product(d.x, 0) + product(d.y, 1) + product(d.z, 2)) >> kSplitBits);
}

/// What rotating a direction with so large a sum of magnitudes can be off by, along it.
inline int32_t margin(const RotatedTransform& transform, Side of, int32_t sum, int32_t reach_b) {
  constexpr int32_t placed = 16712;  // 0.51 of kRestOne
  const bool of_a = of == Side::a;
  const uint32_t stretched = of_a ? 0 : static_cast<uint32_t>(reach_b) * transform.matrix->defect;
  const int32_t turned = of_a ? reach_b : (7 * reach_b + 3) >> 2;
  const uint32_t each = static_cast<uint32_t>(turned + placed) + (stretched >> 9);
  return (turned >> 1) + static_cast<int32_t>((static_cast<uint64_t>(each) * sum) >> 15) + 3;
}

}  // namespace

bool plane_direction(const Vertex& p, const Vertex& q, const Vertex& r, Direction& direction) {
  const Edge u = edge(p, q);
  const Edge v = edge(p, r);
  direction = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  return scale(direction);
}

bool edge_direction(const Vertex& p, const Vertex& q, const Direction& normal,
                    Direction& direction) {
  const Edge e = edge(p, q);
  direction = {e.y * normal.z - e.z * normal.y, e.z * normal.x - e.x * normal.z,
               e.x * normal.y - e.y * normal.x};
  return scale(direction);
}

void Slab::set(const Direction& direction, const Extent& extent, const Transform& transform,
               Side of, int32_t reach_b) {
  Direction seen = direction;
  int32_t offset = 0;
  int32_t wider = 0;
  if (transform.is_rotated()) {
    const RotatedTransform& rotated = transform.rotated();
    const bool of_a = of == Side::a;
    seen = rotate(of_a ? rotated.columns : rotated.matrix->rows, direction);
    const Direction& in_a = of_a ? direction : seen;
    offset = offset_along(in_a, rotated);
    wider = margin(rotated, of,
                   static_cast<int32_t>(magnitude(in_a.x) + magnitude(in_a.y) + magnitude(in_a.z)),
                   reach_b);
  } else {
    const Point& o = transform.translated().offset;
    offset = direction.x * o.x + direction.y * o.y + direction.z * o.z;
  }
  if (of == Side::a) {
    offset = -offset;
  }
  row_ = SplitRow::of(seen.x, seen.y, seen.z);
  const int32_t bias = row_.sum() * kBoundBias;
  least_upper_ = bias + extent.least + offset - wider;
  least_lower_ = bias - extent.most - offset - wider;
}

}  // namespace flashbvh::detail
