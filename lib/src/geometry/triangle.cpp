// Triangle against triangle, decided by the signs of integer determinants.
//
// General case: Guigue and Devillers 2003. Two triangles that cross each other's plane intersect
// the line common to both planes in one interval each; two determinants tell whether these overlap.
//
// Everything else is one of three degenerate cases, told apart by the sides of the planes alone,
// since a triangle without area has no plane and leaves every point on side zero:
// - all six corners in one plane, or both triangles without area: separating axes in projections
// - a segment that crosses the plane of a triangle: the signs of its line about the three edges
//
// Invariant: only differences of corners are multiplied, so positions never matter, and each value
// whose sign is taken is exact.
#include "flashbvh/detail/triangle.hpp"

#include "orientation.hpp"

namespace flashbvh::detail {
namespace {

static_assert(INT64_MAX / kMaxDifference / kMaxDifference / kMaxDifference >= 6,
              "a 3x3 determinant is a sum of six products of three differences");

/// Largest difference for which a cofactor, two products of two differences, fits 32 bits.
constexpr int32_t kMaxNarrow = (1 << 15) - 1;
static_assert(INT32_MAX / kMaxNarrow / kMaxNarrow >= 2, "a cofactor is a sum of two products");

/// A cross product of differences up to kMaxNarrow.
using Narrow = PlaneNormal;
/// The same up to kMaxDifference.
struct Wide {
  int64_t x;
  int64_t y;
  int64_t z;
};

inline int64_t volume(bool narrow, const Point& p, const Point& q, const Point& r, const Point& s) {
  return narrow ? detail::volume<Narrow>(p, q, r, s) : detail::volume<Wide>(p, q, r, s);
}

/// `origin`: a point of the plane.
template <class Cofactors>
inline Sides sides_of_normal(const Cofactors& normal, const Point& origin, const Triangle& asked) {
  return detail::sides_of(
      asked, [&](const Point& corner) { return dot(normal, difference(corner, origin)); });
}

template <class Cofactors>
[[gnu::noinline]] Sides sides_of_plane(const Triangle& plane, const Triangle& asked) {
  return sides_of_normal(normal_of<Cofactors>(plane), plane.corner[0], asked);
}

inline Sides sides_of(bool narrow, const Triangle& plane, const Triangle& asked) {
  return narrow ? sides_of_plane<Narrow>(plane, asked) : sides_of_plane<Wide>(plane, asked);
}

/// Whether the intervals in which two triangles intersect the common line of their planes overlap.
/// Each triangle is mirrored where the other's tip is below, which orders both intervals alike.
bool intervals_overlap(bool narrow, const Triangle& a, Sides of_a, const Triangle& b, Sides of_b) {
  const Tip at = tip_of(of_a);
  const Tip bt = tip_of(of_b);
  const Point& tip_a = a.corner[at.corner];
  const Point& tip_b = b.corner[bt.corner];
  const Point& high_a = a.corner[bt.up ? next(at.corner) : previous(at.corner)];
  const Point& high_b = b.corner[at.up ? next(bt.corner) : previous(bt.corner)];
  const Point& low_a = a.corner[bt.up ? previous(at.corner) : next(at.corner)];
  const Point& low_b = b.corner[at.up ? previous(bt.corner) : next(bt.corner)];
  return volume(narrow, tip_a, high_a, tip_b, high_b) <= 0 &&
         volume(narrow, tip_a, low_a, tip_b, low_b) >= 0;
}

/// Whether a segment on both sides of the plane of `t`, or on it with one end, intersects `t`.
[[gnu::noinline]] bool segment_intersects(const Triangle& segment, Sides of_segment,
                                          const Triangle& t) {
  const unsigned tip = tip_of(of_segment).corner;
  bool left = false;
  bool right = false;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t turn = detail::volume<Wide>(segment.corner[tip], segment.corner[next(tip)],
                                              t.corner[i], t.corner[next(i)]);
    left |= turn > 0;
    right |= turn < 0;
  }
  return !(left && right);
}

/// A projection along one axis onto the other two.
struct Projection {
  int32_t Point::*u;
  int32_t Point::*v;
};

constexpr Projection kProjections[3] = {
    {&Point::x, &Point::y}, {&Point::y, &Point::z}, {&Point::z, &Point::x}};

/// 1 where p, q, r turn left in the projection, -1 where they turn right, 0 on one line.
[[gnu::noinline, gnu::cold]] int turn(const Projection& onto, const Point& p, const Point& q,
                                      const Point& r) {
  const int64_t twice = area(onto.u, onto.v, p, q, r);
  return twice > 0 ? 1 : twice < 0 ? -1 : 0;
}

/// The same of a triangle's corners.
[[gnu::noinline, gnu::cold]] int turn(const Projection& onto, const Triangle& t) {
  return turn(onto, t.corner[0], t.corner[1], t.corner[2]);
}

/// Whether some edge of `a`, in projection, has all of `b` strictly on its outer side. A projected
/// triangle without area has two outer sides.
[[gnu::noinline, gnu::cold]] bool edge_separates(const Projection& onto, const Triangle& a,
                                                 const Triangle& b) {
  const int inner = turn(onto, a);
  for (unsigned i = 0; i < 3; ++i) {
    const Point& p = a.corner[i];
    const Point& q = a.corner[next(i)];
    const int side = turn(onto, p, q, b.corner[0]);
    if (side != 0 && side != inner && side == turn(onto, p, q, b.corner[1]) &&
        side == turn(onto, p, q, b.corner[2])) {
      return true;
    }
  }
  return false;
}

/// Whether one plane contains two triangles without area: false for segments on skew lines.
[[gnu::noinline, gnu::cold]] bool coplanar(const Triangle& a, const Triangle& b) {
  for (unsigned i = 1; i < 3; ++i) {
    for (unsigned j = 1; j < 3; ++j) {
      if (detail::volume<Wide>(a.corner[0], a.corner[i], b.corner[0], b.corner[j]) != 0) {
        return false;
      }
    }
  }
  return true;
}

/// Whether two triangles with overlapping boxes intersect that lie in one plane or both lack area.
///
/// In two dimensions the normals of the edges and the two axes (the boxes) are all the separating
/// axes of segments, points and triangles. Coplanar triangles intersect exactly if they do so in
/// each projection; one in which `a` keeps an area is one-to-one on their plane and decides alone.
[[gnu::noinline, gnu::cold]] bool flat_intersect(const Triangle& a, const Triangle& b) {
  for (const Projection& onto : kProjections) {
    if (edge_separates(onto, a, b) || edge_separates(onto, b, a)) {
      return false;
    }
    if (turn(onto, a) != 0) {
      return true;
    }
  }
  return coplanar(a, b);
}

/// Whether two triangles intersect that neither plane separates. If one of them lies in the other's
/// plane or lacks area, their boxes overlap. Four arguments, the last of them two in one, so that a
/// caller's frame is gone while this runs.
[[gnu::noinline]] bool unseparated_intersect(const Triangle& a, const Triangle& b, Sides of_a,
                                             unsigned of_b_and_narrow) {
  const Sides of_b = {of_b_and_narrow >> 1};
  if (!of_a.all_on_plane() && !of_b.all_on_plane()) {
    return intervals_overlap((of_b_and_narrow & 1) != 0, a, of_a, b, of_b);
  }
  if (!of_a.all_on_plane()) {
    return segment_intersects(a, of_a, b);
  }
  return of_b.all_on_plane() ? flat_intersect(a, b) : segment_intersects(b, of_b, a);
}

inline bool unseparated_intersect(bool narrow, const Triangle& a, Sides of_a, const Triangle& b,
                                  Sides of_b) {
  return unseparated_intersect(a, b, of_a, of_b.bits << 1 | (narrow ? 1u : 0u));
}

/// Whether two triangles with overlapping boxes intersect. `narrow`: no edge exceeds kMaxNarrow.
[[gnu::noinline]] bool intersect(bool narrow, const Triangle& a, const Triangle& b) {
  const Sides of_a = sides_of(narrow, b, a);
  if (of_a.separate()) {
    return false;
  }
  const Sides of_b = sides_of(narrow, a, b);
  return !of_b.separate() && unseparated_intersect(narrow, a, of_a, b, of_b);
}

inline int32_t least(int32_t u, int32_t v) {
  return u < v ? u : v;
}
inline int32_t greatest(int32_t u, int32_t v) {
  return u > v ? u : v;
}

/// The extent of both triangles along an axis, or -1 where their boxes are disjoint.
inline int32_t extent(int32_t Point::*axis, const Triangle& a, const Triangle& b) {
  const Point* const p = a.corner;
  const Point* const q = b.corner;
  const int32_t a_low = least(least(p[0].*axis, p[1].*axis), p[2].*axis);
  const int32_t b_high = greatest(greatest(q[0].*axis, q[1].*axis), q[2].*axis);
  if (a_low > b_high) {
    return -1;
  }
  const int32_t a_high = greatest(greatest(p[0].*axis, p[1].*axis), p[2].*axis);
  const int32_t b_low = least(least(q[0].*axis, q[1].*axis), q[2].*axis);
  if (b_low > a_high) {
    return -1;
  }
  return greatest(a_high, b_high) - least(a_low, b_low);
}

/// Whether the boxes overlap.
[[gnu::noinline, gnu::cold]] bool boxes_overlap(const Triangle& a, const Triangle& b) {
  return extent(&Point::x, a, b) >= 0 && extent(&Point::y, a, b) >= 0 &&
         extent(&Point::z, a, b) >= 0;
}

}  // namespace

bool triangles_intersect(const Triangle& a, const Triangle& b,
                         const PlaneNormal* normal_b) noexcept {
  if (normal_b == nullptr) {
    return boxes_overlap(a, b) && intersect(/*narrow=*/false, a, b);
  }
  const Sides of_a = sides_of_normal(*normal_b, b.corner[0], a);
  if (of_a.separate()) {
    return false;
  }
  const Sides of_b = sides_of_plane<Narrow>(a, b);
  if (of_b.separate() || ((of_a.all_on_plane() || of_b.all_on_plane()) && !boxes_overlap(a, b))) {
    return false;
  }
  return unseparated_intersect(/*narrow=*/true, a, of_a, b, of_b);
}

/// One of the box's sides has all three corners beyond it if they do not overlap.
bool box_overlaps(const PackedBox& box, const Triangle& t) noexcept {
  const Point(&p)[3] = t.corner;
  const auto apart = [](uint32_t upper, uint32_t negated_lower, int32_t u, int32_t v, int32_t w) {
    const int32_t above = static_cast<int32_t>(upper) - kBoundBias;
    const int32_t below = kBoundBias - static_cast<int32_t>(negated_lower);
    return (((above - u) & (above - v) & (above - w)) | ((u - below) & (v - below) & (w - below))) <
           0;
  };
  return !apart(low_half(box.upper_xy), low_half(box.lower_xy), p[0].x, p[1].x, p[2].x) &&
         !apart(high_half(box.upper_xy), high_half(box.lower_xy), p[0].y, p[1].y, p[2].y) &&
         !apart(low_half(box.z), high_half(box.z), p[0].z, p[1].z, p[2].z);
}

void get_near_normal(const Triangle& t, PlaneNormal& normal) noexcept {
  normal = normal_of<Narrow>(t);
}

bool triangles_intersect(const Triangle& a, const Triangle& b) noexcept {
  const int32_t x = extent(&Point::x, a, b);
  if (x < 0) {
    return false;
  }
  const int32_t y = extent(&Point::y, a, b);
  if (y < 0) {
    return false;
  }
  const int32_t z = extent(&Point::z, a, b);
  if (z < 0) {
    return false;
  }
  // The largest value below 2^15 is all ones, so the extents can be or-ed.
  return intersect((x | y | z) <= kMaxNarrow, a, b);
}

}  // namespace flashbvh::detail
