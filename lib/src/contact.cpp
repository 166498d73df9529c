// Where two triangles meet.
//
// General case: each triangle meets the plane of the other one, and so the line common to both
// planes, in an interval that ends on two of its edges (triangle.cpp). The common part runs from
// the later one of the two lower ends to the earlier one of the two upper ends. Which these are is
// told by the signs of determinants; only their coordinates are rounded.
//
// The rest, as in triangle.cpp, is told apart by the sides of the planes alone: a segment that
// crosses the plane of a triangle does so in one point; all else lies in one plane
// (contact_flat.hpp).
//
// Invariant: only differences of corners are multiplied, so the place never matters, and each value
// is exact up to fine_crossing.hpp.
#include "flashbvh/contact.hpp"

#include "contact_flat.hpp"
#include "fine_crossing.hpp"

namespace flashbvh {
namespace {

constexpr int64_t kFarthest = int64_t{2} * kMaxContactCoordinate;
static_assert(INT64_MAX / kFarthest / kFarthest / kFarthest >= 6,
              "a 3x3 determinant is a sum of six products of three differences");

[[gnu::noinline]] Normal normal_of(const PlacedTriangle& t) {
  return cross(difference(t.corner[1], t.corner[0]), difference(t.corner[2], t.corner[0]));
}

/// Six times the signed volume of the tetrahedron p, q, r, s.
[[gnu::noinline]] int64_t volume(const Point& p, const Point& q, const Point& r, const Point& s) {
  return dot(cross(difference(q, p), difference(r, p)), difference(s, p));
}

/// Of a point above a plane through `base`, times the length of the normal.
[[gnu::noinline]] int64_t height_of(const Point& p, const Point& base, const Normal& normal) {
  return dot(normal, difference(p, base));
}

constexpr unsigned kAllCorners = 7;

/// On which side of a plane the corners of a triangle lie: bit i for corner i strictly above, bit
/// 3 + i for corner i strictly below. 0 if all are in the plane.
[[gnu::noinline]] unsigned sides_of(const PlacedTriangle& t, const Point& base,
                                    const Normal& normal) {
  unsigned sides = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t height = height_of(t.corner[i], base, normal);
    sides |= height > 0 ? 1u << i : height < 0 ? 8u << i : 0u;
  }
  return sides;
}

/// The corner alone on its side of a plane, of a triangle that meets the plane and doesn't lie in
/// it. Both edges from it meet the plane in exactly one point; a tip on the plane itself is below
/// if the others are above.
struct Tip {
  unsigned corner;
  bool up;
};

inline Tip tip_of(unsigned sides) {
  const unsigned above = sides & kAllCorners;
  const unsigned upper = above != 0 ? above : kAllCorners ^ (sides >> 3);
  const bool one = (upper & (upper - 1)) == 0;
  return {(one ? upper : kAllCorners ^ upper) >> 1, one};
}

/// The two edges of a triangle on which its part of the common line begins and ends.
struct Interval {
  const Point* tip;
  const Point* low;
  const Point* high;
};

/// `forwards`: whether the edge to the next corner is the low one.
inline Interval interval_of(const PlacedTriangle& t, unsigned tip, bool forwards) {
  const Point* const next = &t.corner[tip == 2 ? 0 : tip + 1];
  const Point* const previous = &t.corner[tip == 0 ? 2 : tip - 1];
  return {&t.corner[tip], forwards ? next : previous, forwards ? previous : next};
}

/// An edge that has an end of the common part on it.
struct Edge {
  const Point* tip;
  const Point* corner;
  bool of_b;
};

/// Of two edges that meet the common line in one point, neither argument's comes first.
inline Edge either(const Point* tip_a, const Point* of_a, const Point* tip_b, const Point* of_b) {
  return edge_before(*tip_b, *of_b, *tip_a, *of_a) ? Edge{tip_b, of_b, true}
                                                   : Edge{tip_a, of_a, false};
}

/// Sets the edges that have the two ends of the common part, of intervals that overlap.
///
/// The volume of an edge of `a` and one of `b` is positive where the first one meets the line
/// before the second one does.
[[gnu::noinline]] void choose(const Interval& a, const Interval& b, Edge (&edges)[2]) {
  for (unsigned high = 0; high < 2; ++high) {
    const Point* const of_a = high != 0 ? a.high : a.low;
    const Point* of_b = high != 0 ? b.low : b.high;
    if (volume(*a.tip, *of_a, *b.tip, *of_b) == 0) {
      edges[0] = edges[1] = either(a.tip, of_a, b.tip, of_b);
      return;
    }
    of_b = high != 0 ? b.high : b.low;
    const int64_t order = volume(*a.tip, *of_a, *b.tip, *of_b);
    edges[high] = order == 0                   ? either(a.tip, of_a, b.tip, of_b)
                  : (order > 0) == (high != 0) ? Edge{a.tip, of_a, false}
                                               : Edge{b.tip, of_b, true};
  }
}

/// Each triangle is mirrored where the other one's tip is below, which orders both intervals alike.
[[gnu::noinline]] void choose_edges(const PlacedTriangle& a, unsigned sides_a,
                                    const PlacedTriangle& b, unsigned sides_b, Edge (&edges)[2]) {
  const Tip tip_a = tip_of(sides_a);
  const Tip tip_b = tip_of(sides_b);
  choose(interval_of(a, tip_a.corner, !tip_b.up), interval_of(b, tip_b.corner, tip_a.up), edges);
}

/// Where an edge meets a plane that it doesn't lie in.
[[gnu::noinline]] void set_piercing_point(const Point& p, const Point& q, const Point& base,
                                          const Normal& normal, FinePoint& point) {
  const int64_t height = height_of(p, base, normal);
  set_crossing(p, q, height, height_of(q, base, normal), point);
}

[[gnu::noinline]] void set_crossing_ends(const PlacedTriangle& a, unsigned sides_a,
                                         const PlacedTriangle& b, unsigned sides_b,
                                         Contact& contact) {
  Edge edges[2];
  choose_edges(a, sides_a, b, sides_b, edges);
  for (unsigned i = 0; i < 2; ++i) {
    const Edge& edge = edges[i];
    const PlacedTriangle& plane = edge.of_b ? a : b;
    set_piercing_point(*edge.tip, *edge.corner, plane.corner[0],
                       edge.of_b ? contact.normal_a : contact.normal_b, contact.ends[i]);
  }
}

/// A triangle without area and a plane that doesn't contain it.
[[gnu::noinline]] void set_piercing_ends(const PlacedTriangle& thin, const Point& base,
                                         const Normal& normal, FinePoint (&ends)[2]) {
  const Shape segment = shape_of(thin, false);
  set_piercing_point(*segment.corner[0], *segment.corner[1], base, normal, ends[0]);
  ends[1] = ends[0];
}

[[gnu::noinline]] void set_ends(const PlacedTriangle& a, const PlacedTriangle& b,
                                Contact& contact) {
  const unsigned sides_a = sides_of(a, b.corner[0], contact.normal_b);
  const unsigned sides_b = sides_of(b, a.corner[0], contact.normal_a);
  if (sides_a != 0 && sides_b != 0) {
    set_crossing_ends(a, sides_a, b, sides_b, contact);
  } else if (sides_a != 0) {
    set_piercing_ends(a, b.corner[0], contact.normal_b, contact.ends);
  } else if (sides_b != 0) {
    set_piercing_ends(b, a.corner[0], contact.normal_a, contact.ends);
  } else {
    contact.kind = contact.kind == ContactKind::segment ? ContactKind::coplanar : contact.kind;
    set_flat_ends(a, b, contact);
  }
}

[[gnu::noinline]] void put_in_order(FinePoint (&ends)[2]) {
  if (comes_before(ends[1], ends[0])) {
    const FinePoint last = ends[0];
    ends[0] = ends[1];
    ends[1] = last;
  }
}

}  // namespace

Contact contact_of(const PlacedTriangle& a, const PlacedTriangle& b) noexcept {
  Contact contact;
  contact.normal_a = normal_of(a);
  contact.normal_b = normal_of(b);
  contact.kind = is_zero(contact.normal_a) || is_zero(contact.normal_b) ? ContactKind::degenerate
                                                                        : ContactKind::segment;
  set_ends(a, b, contact);
  put_in_order(contact.ends);
  return contact;
}

}  // namespace flashbvh
