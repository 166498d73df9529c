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
/// A point on the lattice as a vertex.
inline Vertex vertex_of(const Point& p) {
  return {static_cast<int16_t>(p.x), static_cast<int16_t>(p.y), static_cast<int16_t>(p.z)};
}
inline Vertex any_vertex(Random& random, int32_t reach) {
  return vertex_of(any_point(random, reach));
}
inline Triangle any_triangle(Random& random, int32_t reach) {
  return {{any_point(random, reach), any_point(random, reach), any_point(random, reach)}};
}

/// A random coordinate of the lattice, within `reach` of `at`.
inline int16_t coordinate_near(Random& random, int32_t at, int32_t reach) {
  const int32_t any = at + random.between(-reach, reach);
  return static_cast<int16_t>(any > kMaxCoordinate    ? kMaxCoordinate
                              : any < -kMaxCoordinate ? -kMaxCoordinate
                                                      : any);
}
/// A random coordinate, often near 0 or next to an end of the lattice.
inline int16_t any_coordinate(Random& random) {
  const uint32_t kind = random.below(4);
  return kind == 0   ? coordinate_near(random, 0, 3)
         : kind == 1 ? coordinate_near(random, kMaxCoordinate, 2)
         : kind == 2 ? coordinate_near(random, -kMaxCoordinate, 2)
                     : coordinate_near(random, 0, kMaxCoordinate);
}

/// The smallest box of two vertices.
inline Box box_around(const Vertex& u, const Vertex& v) {
  Box box{};
  for (const auto axis : kVertexAxes) {
    box.lower.*axis = u.*axis < v.*axis ? u.*axis : v.*axis;
    box.upper.*axis = u.*axis < v.*axis ? v.*axis : u.*axis;
  }
  return box;
}
inline Box any_box(Random& random) {
  const auto any = [&random] { return any_coordinate(random); };
  const Vertex corners[2] = {{any(), any(), any()}, {any(), any(), any()}};
  return box_around(corners[0], corners[1]);
}
/// Whether `a` overlaps `b` translated.
inline bool overlap(const Box& a, const Box& b, const Point& translation = {0, 0, 0}) {
  bool overlaps = true;
  for (int i = 0; i < 3; ++i) {
    const auto axis = kVertexAxes[i];
    const int64_t t = translation.*kPointAxes[i];
    overlaps = overlaps && a.lower.*axis <= b.upper.*axis + t && b.lower.*axis + t <= a.upper.*axis;
  }
  return overlaps;
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

/// Points, vertices and normals.
template <class Any>
auto same(const Any& p, const Any& q) -> decltype(p.x == q.x && p.y == q.y && p.z == q.z) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}
inline bool same(const Triangle& t, const Triangle& u) {
  return same(t.corner[0], u.corner[0]) && same(t.corner[1], u.corner[1]) &&
         same(t.corner[2], u.corner[2]);
}
inline bool same(const Box& p, const Box& q) {
  return same(p.lower, q.lower) && same(p.upper, q.upper);
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
  return {pack(box), random.one_of(rests)};
}

}  // namespace flashbvh::test
