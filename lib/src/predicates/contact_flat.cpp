// The corners of the common part of two coplanar outlines, and the outermost two along its longest
// axis.
//
// A corner of the common part is a corner of one outline inside the other one, or a proper crossing
// of two edges. Invariant: signs of exact 2x2 determinants decide which points these are, in a
// projection that is one-to-one on the plane. So no point comes twice with different rounding.
//
// The corners are enumerated again if the common part is longest along y or z. Keeping the
// outermost points of all three axes would take 48 more bytes of stack.
#include "contact_flat.hpp"

#include "fine_crossing.hpp"

namespace flashbvh::detail {
namespace {

constexpr int64_t FinePoint::*kFineAxes[3] = {&FinePoint::x, &FinePoint::y, &FinePoint::z};

/// Two outlines and a projection onto two axes.
struct Flat {
  Outline a;
  Outline b;
  int32_t Point::*u;
  int32_t Point::*v;
};

[[gnu::noinline]] int64_t turn(const Flat& flat, const Point& p, const Point& q, const Point& r) {
  return area(flat.u, flat.v, p, q, r);
}

[[gnu::noinline]] bool contains(const Flat& flat, const Outline& outline, const Point& p) {
  bool left = false;
  bool right = false;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t side = turn(flat, *outline.corner[i], *outline.corner[next(i)], p);
    left |= side > 0;
    right |= side < 0;
  }
  // A segment consists of an edge and its reverse, so a point off its line is both left and right.
  return !(left && right) && (!outline.is_segment() || (!comes_before(p, *outline.corner[0]) &&
                                                        !comes_before(*outline.corner[1], p)));
}

inline bool opposite(int64_t u, int64_t v) {
  return (u > 0 && v < 0) || (u < 0 && v > 0);
}

/// Returns whether the interiors of two edges cross; if so, sets the point.
[[gnu::noinline]] bool edges_cross(const Flat& flat, unsigned edge_a, unsigned edge_b,
                                   FinePoint& point) {
  const Point* p = flat.a.corner[edge_a];
  const Point* q = flat.a.corner[next(edge_a)];
  const Point* r = flat.b.corner[edge_b];
  const Point* s = flat.b.corner[next(edge_b)];
  // Rounding depends on the edge that gives the point; the order of arguments must not choose it.
  if (edge_before(*r, *s, *p, *q)) {
    const Point* const start = p;
    const Point* const end = q;
    p = r;
    q = s;
    r = start;
    s = end;
  }
  if (!opposite(turn(flat, *p, *q, *r), turn(flat, *p, *q, *s))) {
    return false;
  }
  const int64_t of_p = turn(flat, *r, *s, *p);
  const int64_t of_q = turn(flat, *r, *s, *q);
  if (!opposite(of_p, of_q)) {
    return false;
  }
  set_crossing(*p, *q, of_p, of_q, point);
  return true;
}

[[gnu::noinline]] bool corner_inside(const Flat& flat, const Outline& of, unsigned corner,
                                     const Outline& in, FinePoint& point) {
  const Point& p = *of.corner[corner];
  point = {int64_t{p.x} * kFineOne, int64_t{p.y} * kFineOne, int64_t{p.z} * kFineOne};
  return contains(flat, in, p);
}

/// The box of all points found, and the outermost points along one axis. Ties go to the first and
/// the last point, so that the order of corners has no influence.
///
/// The box stores only low words: all points are within 2^26 steps of each other.
struct Found {
  uint32_t least[3];
  uint32_t most[3];
  int64_t FinePoint::*axis;
  FinePoint* ends;

  /// True if no point is found: the box ends before it begins.
  bool is_empty() const { return most[0] + 1 == least[0]; }
};

/// If there are no points, the result is arbitrary but must not overflow.
[[gnu::noinline]] void clear(Found& found) {
  for (int i = 0; i < 3; ++i) {
    found.least[i] = 1;
    found.most[i] = 0;
  }
  found.ends[0] = found.ends[1] = {0, 0, 0};
}

/// Widens the range by a coordinate.
inline void take(Found& found, int axis, int64_t coordinate) {
  const auto at = static_cast<uint32_t>(coordinate);
  if (fine_difference(at, found.least[axis]) < 0) {
    found.least[axis] = at;
  } else if (fine_difference(at, found.most[axis]) > 0) {
    found.most[axis] = at;
  }
}

[[gnu::noinline]] void add(Found& found, const FinePoint& p) {
  if (found.is_empty()) {
    found.ends[0] = found.ends[1] = p;
    for (int i = 0; i < 3; ++i) {
      found.least[i] = found.most[i] = static_cast<uint32_t>(p.*kFineAxes[i]);
    }
    return;
  }
  take(found, 0, p.x);
  take(found, 1, p.y);
  take(found, 2, p.z);
  const auto axis = found.axis;
  const int32_t below = fine_difference(p.*axis, found.ends[0].*axis);
  const int32_t above = fine_difference(p.*axis, found.ends[1].*axis);
  if (below < 0 || (below == 0 && comes_before(p, found.ends[0]))) {
    found.ends[0] = p;
  }
  if (above > 0 || (above == 0 && comes_before(found.ends[1], p))) {
    found.ends[1] = p;
  }
}

/// Adds each corner of the common part, and no other point of it.
[[gnu::noinline]] void add_corners(const Flat& flat, Found& found) {
  FinePoint point;
  for (unsigned i = 0; i < 3; ++i) {
    if (corner_inside(flat, flat.a, i, flat.b, point)) {
      add(found, point);
    }
    if (corner_inside(flat, flat.b, i, flat.a, point)) {
      add(found, point);
    }
    for (unsigned j = 0; j < 3; ++j) {
      if (edges_cross(flat, i, j, point)) {
        add(found, point);
      }
    }
  }
}

/// The longest axis of the box; the first one on a tie.
inline int longest_axis(const Found& found) {
  const uint32_t x = found.most[0] - found.least[0];
  const uint32_t y = found.most[1] - found.least[1];
  const uint32_t z = found.most[2] - found.least[2];
  return z > x && z > y ? 2 : y > x ? 1 : 0;
}

/// The normal of the plane through two segments; zero if they lie on one line.
inline Normal plane_through(const Outline& a, const Outline& b) {
  return cross<Normal>(difference(*a.corner[1], *a.corner[0]),
                       difference(*b.corner[1], *b.corner[0]));
}

/// Sets a projection that is one-to-one on the common plane; for outlines on a line, any one.
[[gnu::noinline]] void set_projection(Flat& flat, const Contact& contact) {
  const Normal plane = !is_zero(contact.normal_a)   ? contact.normal_a
                       : !is_zero(contact.normal_b) ? contact.normal_b
                                                    : plane_through(flat.a, flat.b);
  flat.u = plane.z != 0 ? &Point::x : plane.x != 0 ? &Point::y : &Point::z;
  flat.v = plane.z != 0 ? &Point::y : plane.x != 0 ? &Point::z : &Point::x;
}

}  // namespace

Outline outline_of(const Triangle& t, bool has_area) {
  const Point* const corner = t.corner;
  if (has_area) {
    return {{&corner[0], &corner[1], &corner[2]}};
  }
  const Point* first = &corner[0];
  const Point* last = &corner[0];
  for (unsigned i = 1; i < 3; ++i) {
    first = comes_before(corner[i], *first) ? &corner[i] : first;
    last = comes_before(*last, corner[i]) ? &corner[i] : last;
  }
  return {{first, last, last}};
}

[[gnu::noinline]] void set_flat_ends(const Triangle& a, const Triangle& b, Contact& contact) {
  Flat flat;
  flat.a = outline_of(a, !is_zero(contact.normal_a));
  flat.b = outline_of(b, !is_zero(contact.normal_b));
  set_projection(flat, contact);
  Found found;
  found.ends = contact.ends;
  int longest = 0;
  do {
    clear(found);
    found.axis = kFineAxes[longest];
    add_corners(flat, found);
    longest = longest_axis(found);
  } while (found.axis != kFineAxes[longest]);
}

}  // namespace flashbvh::detail
