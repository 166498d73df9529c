// The contact of two triangles that intersect.
//
// General case: each triangle intersects the plane of the other one, and so the line common to both
// planes, in an interval that ends on two of its edges (triangle.cpp). The common part runs from
// the later of the two lower ends to the earlier of the two upper ends. Signs of determinants
// decide which ends these are; only coordinates are rounded.
//
// The sides of the planes distinguish the degenerate cases, as in triangle.cpp. A segment crosses
// the plane of a triangle in one point; all else lies in one plane (contact_flat.hpp).
//
// Invariant: only differences of corners are multiplied, so their position never matters. Each
// value is exact up to fine_crossing.hpp.
#include "flashbvh/triangle.hpp"

#include "contact_flat.hpp"
#include "fine_crossing.hpp"

namespace flashbvh {

using namespace detail;

namespace {

constexpr int64_t kFarthest = kMaxContactDistance;
static_assert(INT64_MAX / kFarthest / kFarthest / kFarthest >= 6,
              "a 3x3 determinant is a sum of six products of three differences");

[[gnu::noinline]] Normal normal_of(const Triangle& t) {
  return detail::normal_of<Normal>(t);
}

/// Height of a point above the plane through `base`, times the length of the normal.
[[gnu::noinline]] int64_t height_of(const Point& p, const Point& base, const Normal& normal) {
  return dot(normal, difference(p, base));
}

[[gnu::noinline]] Sides sides_of(const Triangle& t, const Point& base, const Normal& normal) {
  return detail::sides_of(t, [&](const Point& corner) { return height_of(corner, base, normal); });
}

/// The two edges of a triangle on which its part of the common line begins and ends.
struct Interval {
  const Point* tip;
  const Point* low;
  const Point* high;
};

/// `forwards`: whether the edge to the next corner is the low one.
inline Interval interval_of(const Triangle& t, unsigned tip, bool forwards) {
  const Point* const next = &t.corner[detail::next(tip)];
  const Point* const previous = &t.corner[detail::previous(tip)];
  return {&t.corner[tip], forwards ? next : previous, forwards ? previous : next};
}

/// An edge that has an end of the common part on it.
struct Edge {
  const Point* tip;
  const Point* corner;
  bool of_b;
};

/// Chooses between two edges that meet the common line in one point, whatever the arguments' order.
inline Edge either(const Point* tip_a, const Point* of_a, const Point* tip_b, const Point* of_b) {
  return edge_before(*tip_b, *of_b, *tip_a, *of_a) ? Edge{tip_b, of_b, true}
                                                   : Edge{tip_a, of_a, false};
}

/// Sets the edges on which the common part of two overlapping intervals ends.
///
/// The volume of an edge of `a` and an edge of `b` is positive if the edge of `a` intersects the
/// line first.
[[gnu::noinline]] void choose(const Interval& a, const Interval& b, Edge (&edges)[2]) {
  for (unsigned high = 0; high < 2; ++high) {
    const Point* const of_a = high != 0 ? a.high : a.low;
    const Point* of_b = high != 0 ? b.low : b.high;
    if (volume<Normal>(*a.tip, *of_a, *b.tip, *of_b) == 0) {
      edges[0] = edges[1] = either(a.tip, of_a, b.tip, of_b);
      return;
    }
    of_b = high != 0 ? b.high : b.low;
    const int64_t order = volume<Normal>(*a.tip, *of_a, *b.tip, *of_b);
    edges[high] = order == 0                   ? either(a.tip, of_a, b.tip, of_b)
                  : (order > 0) == (high != 0) ? Edge{a.tip, of_a, false}
                                               : Edge{b.tip, of_b, true};
  }
}

/// Mirrors a triangle if the other one's tip is below, which orders both intervals alike.
[[gnu::noinline]] void choose_edges(const Triangle& a, Sides sides_a, const Triangle& b,
                                    Sides sides_b, Edge (&edges)[2]) {
  const Tip tip_a = tip_of(sides_a);
  const Tip tip_b = tip_of(sides_b);
  choose(interval_of(a, tip_a.corner, !tip_b.up), interval_of(b, tip_b.corner, tip_a.up), edges);
}

/// Sets the point in which an edge intersects a plane that does not contain it.
[[gnu::noinline]] void set_piercing_point(const Point& p, const Point& q, const Point& base,
                                          const Normal& normal, FinePoint& point) {
  const int64_t height = height_of(p, base, normal);
  set_crossing(p, q, height, height_of(q, base, normal), point);
}

[[gnu::noinline]] void set_crossing_ends(const Triangle& a, Sides sides_a, const Triangle& b,
                                         Sides sides_b, Contact& contact) {
  Edge edges[2];
  choose_edges(a, sides_a, b, sides_b, edges);
  for (unsigned i = 0; i < 2; ++i) {
    const Edge& edge = edges[i];
    const Triangle& plane = edge.of_b ? a : b;
    set_piercing_point(*edge.tip, *edge.corner, plane.corner[0],
                       edge.of_b ? contact.normal_a : contact.normal_b, contact.ends[i]);
  }
}

/// Sets the ends for a triangle without area and a plane that does not contain it.
[[gnu::noinline]] void set_piercing_ends(const Triangle& thin, const Point& base,
                                         const Normal& normal, FinePoint (&ends)[2]) {
  const Outline segment = outline_of(thin, false);
  set_piercing_point(*segment.corner[0], *segment.corner[1], base, normal, ends[0]);
  ends[1] = ends[0];
}

[[gnu::noinline]] void set_ends(const Triangle& a, const Triangle& b, Contact& contact) {
  const Sides sides_a = sides_of(a, b.corner[0], contact.normal_b);
  const Sides sides_b = sides_of(b, a.corner[0], contact.normal_a);
  if (!sides_a.all_on_plane() && !sides_b.all_on_plane()) {
    set_crossing_ends(a, sides_a, b, sides_b, contact);
  } else if (!sides_a.all_on_plane()) {
    set_piercing_ends(a, b.corner[0], contact.normal_b, contact.ends);
  } else if (!sides_b.all_on_plane()) {
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

Contact contact_of(const Triangle& a, const Triangle& b) noexcept {
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
