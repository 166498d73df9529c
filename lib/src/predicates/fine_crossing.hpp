// Shared by the parts of a contact: orders of points and edges, and the point in which an edge
// crosses a plane or a line.
#pragma once

#include "flashbvh/triangle.hpp"
#include "orientation.hpp"

namespace flashbvh::detail {

/// Difference of two coordinates of one contact, by low words: it is within 2^26 steps.
template <class Fine>
inline int32_t fine_difference(Fine u, Fine v) {
  return static_cast<int32_t>(static_cast<uint32_t>(u) - static_cast<uint32_t>(v));
}

/// Orders points by x, then y, then z. On a line this is the order along it.
inline bool comes_before(const Point& p, const Point& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}
inline bool comes_before(const FinePoint& p, const FinePoint& q) {
  const int32_t x = fine_difference(p.x, q.x);
  const int32_t y = fine_difference(p.y, q.y);
  return x != 0 ? x < 0 : y != 0 ? y < 0 : fine_difference(p.z, q.z) < 0;
}

/// Orders edges independently of their direction, by their first ends. Edges with one first end are
/// equal.
inline bool edge_before(const Point& p, const Point& q, const Point& r, const Point& s) {
  return comes_before(comes_before(p, q) ? p : q, comes_before(r, s) ? r : s);
}

inline bool is_zero(const Normal& n) {
  return (n.x | n.y | n.z) == 0;
}

/// Sets `point` to the point of the edge p, q at height zero:
/// p + (q - p) * height_p / (height_p - height_q). Heights have opposite signs, or one is zero.
///
/// Heights: below 2^62. Each coordinate is off by at most 0.53 steps of 1/256 cell. Swapping the
/// ends, or the signs of both heights, changes nothing.
void set_crossing(const Point& p, const Point& q, int64_t height_p, int64_t height_q,
                  FinePoint& point);

}  // namespace flashbvh::detail
