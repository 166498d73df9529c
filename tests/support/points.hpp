// Points, triangles and boxes: random ones, translated ones, comparisons.
#pragma once

#include <stdint.h>

#include "flashbvh/contact.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/lattice.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

constexpr int32_t Point::*kPointAxes[3] = {&Point::x, &Point::y, &Point::z};
constexpr int16_t Vertex::*kVertexAxes[3] = {&Vertex::x, &Vertex::y, &Vertex::z};

/// A random point within +-reach on each axis.
inline Point any_point(Random& random, int32_t reach) {
  const int32_t x = random.between(-reach, reach);
  const int32_t y = random.between(-reach, reach);
  return {x, y, random.between(-reach, reach)};
}
inline Vertex any_vertex(Random& random, int32_t reach) {
  const Point p = any_point(random, reach);
  return {static_cast<int16_t>(p.x), static_cast<int16_t>(p.y), static_cast<int16_t>(p.z)};
}
inline Triangle any_triangle(Random& random, int32_t reach) {
  return {{any_point(random, reach), any_point(random, reach), any_point(random, reach)}};
}

inline Point sum(const Point& p, const Point& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline Point scaled(int32_t n, const Point& p) {
  return {n * p.x, n * p.y, n * p.z};
}
inline Triangle shifted(const Triangle& t, const Point& by) {
  return {{sum(t.corner[0], by), sum(t.corner[1], by), sum(t.corner[2], by)}};
}

/// Corner `i` in the n-th of six orders; the last three reverse the winding.
inline Triangle ordered(const Triangle& t, int n) {
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const int* const i = kOrders[n];
  return {{t.corner[i[0]], t.corner[i[1]], t.corner[i[2]]}};
}

template <class Vector>
bool same_numbers(const Vector& p, const Vector& q) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}
inline bool same(const Point& p, const Point& q) {
  return same_numbers(p, q);
}
inline bool same(const FinePoint& p, const FinePoint& q) {
  return same_numbers(p, q);
}
inline bool same(const Normal& p, const Normal& q) {
  return same_numbers(p, q);
}
inline bool same(const Triangle& t, const Triangle& u) {
  return same(t.corner[0], u.corner[0]) && same(t.corner[1], u.corner[1]) &&
         same(t.corner[2], u.corner[2]);
}
inline bool same(const Box& p, const Box& q) {
  return same_numbers(p.lower, q.lower) && same_numbers(p.upper, q.upper);
}
inline bool same(const PackedBox& a, const PackedBox& b) {
  return a.upper_xy == b.upper_xy && a.lower_xy == b.lower_xy && a.z == b.z;
}
/// Whether two contacts have equal kinds and ends.
inline bool same_place(const Contact& c, const Contact& d) {
  return c.kind == d.kind && same(c.ends[0], d.ends[0]) && same(c.ends[1], d.ends[1]);
}

/// A packed box followed by other data, as in a node: some overlap tests read that data too, and
/// their results must not depend on it.
struct BoxInNode {
  PackedBox box;
  uint32_t rest;
};

inline BoxInNode in_node(Random& random, const Box& box) {
  constexpr uint32_t rests[] = {0, 0xFFFF, 0xFFFF0000, 0x80008000, 0x7FFF7FFF, 0xFFFFFFFF};
  return {pack(box), rests[random.below(6)]};
}

}  // namespace flashbvh::test
