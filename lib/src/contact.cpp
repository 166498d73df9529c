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

constexpr int64_t kFarthest = 2 * kMaxContactCoordinate;
static_assert(INT64_MAX / kFarthest / kFarthest / kFarthest >= 6,
              "a 3x3 determinant is a sum of six products of three differences");

inline bool is_zero(const Normal& n) {
  return (n.x | n.y | n.z) == 0;
}

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

/// On which edge an end lies: from the tip to `corner`.
struct End {
  const Point* corner;
  bool of_b;
};

/// Of two edges that meet the common line in one point, neither argument's comes first.
inline End either(const Interval& a, const Point* end_a, const Interval& b, const Point* end_b) {
  const bool of_b = edge_before(*b.tip, *end_b, *a.tip, *end_a);
  return {of_b ? end_b : end_a, of_b};
}

/// Sets the two ends of the common part of two intervals that overlap.
///
/// The volume of an edge of `a` and one of `b` is positive where the first one meets the line
/// before the second one does.
[[gnu::noinline]] void choose_ends(const Interval& a, const Interval& b, End (&ends)[2]) {
  for (unsigned i = 0; i < 2; ++i) {
    const bool high = i != 0;
    const Point* const of_a = high ? a.high : a.low;
    const Point* const of_b = high ? b.high : b.low;
    const Point* const beyond_b = high ? b.low : b.high;
    if (volume(*a.tip, *of_a, *b.tip, *beyond_b) == 0) {
      ends[0] = ends[1] = either(a, of_a, b, beyond_b);
      return;
    }
    const int64_t order = volume(*a.tip, *of_a, *b.tip, *of_b);
    ends[i] = order == 0            ? either(a, of_a, b, of_b)
              : (order > 0) == high ? End{of_a, false}
                                    : End{of_b, true};
  }
}

/// Where an edge meets a plane that it doesn't lie in.
[[gnu::noinline]] FinePoint piercing_point(const Point& p, const Point& q, const Point& base,
                                           const Normal& normal) {
  return crossing(p, q, height_of(p, base, normal), height_of(q, base, normal));
}

/// Each triangle is mirrored where the other one's tip is below, which orders both intervals alike.
[[gnu::noinline]] void set_crossing_ends(const PlacedTriangle& a, unsigned sides_a,
                                         const PlacedTriangle& b, unsigned sides_b,
                                         Contact& contact) {
  const Tip tip_a = tip_of(sides_a);
  const Tip tip_b = tip_of(sides_b);
  const Interval of_a = interval_of(a, tip_a.corner, !tip_b.up);
  const Interval of_b = interval_of(b, tip_b.corner, tip_a.up);
  End ends[2];
  choose_ends(of_a, of_b, ends);
  for (unsigned i = 0; i < 2; ++i) {
    contact.ends[i] =
        ends[i].of_b ? piercing_point(*of_b.tip, *ends[i].corner, a.corner[0], contact.normal_a)
                     : piercing_point(*of_a.tip, *ends[i].corner, b.corner[0], contact.normal_b);
  }
}

/// A triangle without area and a plane that doesn't contain it.
[[gnu::noinline]] void set_piercing_ends(const PlacedTriangle& thin, const Point& base,
                                         const Normal& normal, FinePoint (&ends)[2]) {
  const Shape segment = shape_of(thin, false);
  ends[0] = piercing_point(*segment.corner[0], *segment.corner[1], base, normal);
  ends[1] = ends[0];
}

void set_ends(const PlacedTriangle& a, const PlacedTriangle& b, Contact& contact) {
  const unsigned sides_a = sides_of(a, b.corner[0], contact.normal_b);
  const unsigned sides_b = sides_of(b, a.corner[0], contact.normal_a);
  const bool area_a = !is_zero(contact.normal_a);
  const bool area_b = !is_zero(contact.normal_b);
  contact.kind = area_a && area_b ? ContactKind::segment : ContactKind::degenerate;
  if (sides_a != 0 && sides_b != 0) {
    set_crossing_ends(a, sides_a, b, sides_b, contact);
  } else if (sides_a != 0) {
    set_piercing_ends(a, b.corner[0], contact.normal_b, contact.ends);
  } else if (sides_b != 0) {
    set_piercing_ends(b, a.corner[0], contact.normal_a, contact.ends);
  } else {
    contact.kind = area_a && area_b ? ContactKind::coplanar : ContactKind::degenerate;
    flat_ends(a, area_a, b, area_b, area_a ? contact.normal_a : contact.normal_b, contact.ends);
  }
}

}  // namespace

Contact contact_of(const PlacedTriangle& a, const PlacedTriangle& b) noexcept {
  Contact contact;
  contact.normal_a = normal_of(a);
  contact.normal_b = normal_of(b);
  set_ends(a, b, contact);
  if (comes_before(contact.ends[1], contact.ends[0])) {
    const FinePoint last = contact.ends[0];
    contact.ends[0] = contact.ends[1];
    contact.ends[1] = last;
  }
  return contact;
}

}  // namespace flashbvh
