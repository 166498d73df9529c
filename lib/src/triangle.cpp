// Triangle against triangle, decided by the signs of integer determinants.
//
// General case: Guigue and Devillers 2003. Two triangles that cross each other's plane meet the
// line common to both planes in one interval each; two determinants tell whether these overlap.
//
// Everything else is one of three degenerate cases, told apart by the sides of the planes alone,
// since a triangle without area has no plane and leaves every point on side zero:
// - all six corners in one plane, or both triangles without area: separating axes in projections
// - a segment that crosses the plane of a triangle: the signs of its line about the three edges
//
// Invariant: only differences of corners are multiplied, so positions never matter, and each value
// whose sign is taken is exact.
#include "flashbvh/triangle.hpp"

#include "vector.hpp"

namespace flashbvh {
namespace {

static_assert(INT64_MAX / kMaxDifference / kMaxDifference / kMaxDifference >= 6,
              "a 3x3 determinant is a sum of six products of three differences");

/// Largest difference for which a cofactor, two products of two differences, fits 32 bits.
constexpr int32_t kMaxNarrow = (1 << 15) - 1;
static_assert(INT32_MAX / kMaxNarrow / kMaxNarrow >= 2, "a cofactor is a sum of two products");

constexpr unsigned kAllCorners = 7;

/// A cross product. Cofactor: int32_t up to kMaxNarrow, int64_t up to kMaxDifference.
template <typename Cofactor>
struct Normal {
  Cofactor x;
  Cofactor y;
  Cofactor z;
};

template <typename Cofactor>
inline Normal<Cofactor> cross(const Vector& u, const Vector& v) {
  const Normal<Cofactor> promoted = {u.x, u.y, u.z};
  return {promoted.y * v.z - promoted.z * v.y, promoted.z * v.x - promoted.x * v.z,
          promoted.x * v.y - promoted.y * v.x};
}

template <typename Cofactor>
inline int64_t dot(const Normal<Cofactor>& n, const Vector& v) {
  return static_cast<int64_t>(n.x) * v.x + static_cast<int64_t>(n.y) * v.y +
         static_cast<int64_t>(n.z) * v.z;
}

/// Six times the signed volume of the tetrahedron p, q, r, s.
template <typename Cofactor>
[[gnu::noinline]] int64_t volume(const Point& p, const Point& q, const Point& r, const Point& s) {
  return dot(cross<Cofactor>(difference(q, p), difference(r, p)), difference(s, p));
}

inline int64_t volume(bool narrow, const Point& p, const Point& q, const Point& r, const Point& s) {
  return narrow ? volume<int32_t>(p, q, r, s) : volume<int64_t>(p, q, r, s);
}

/// On which sides of a plane the corners of a triangle lie: bit i for corner i strictly above, bit
/// 3 + i for corner i strictly below.
struct Sides {
  unsigned bits;

  unsigned above() const { return bits & kAllCorners; }
  unsigned below() const { return bits >> 3; }
  bool separate() const { return above() == kAllCorners || below() == kAllCorners; }
  bool all_on_plane() const { return bits == 0; }
};

template <typename Cofactor>
[[gnu::noinline]] Sides sides_of(const PlacedTriangle& plane, const PlacedTriangle& asked) {
  const Point& origin = plane.corner[0];
  const Normal<Cofactor> normal =
      cross<Cofactor>(difference(plane.corner[1], origin), difference(plane.corner[2], origin));
  unsigned bits = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t height = dot(normal, difference(asked.corner[i], origin));
    if (height > 0) {
      bits |= 1u << i;
    } else if (height < 0) {
      bits |= 8u << i;
    }
  }
  return {bits};
}

inline Sides sides_of(bool narrow, const PlacedTriangle& plane, const PlacedTriangle& asked) {
  return narrow ? sides_of<int32_t>(plane, asked) : sides_of<int64_t>(plane, asked);
}

/// The corner alone on its side of a plane. Both edges from it end strictly on the other side or,
/// unless it is itself on the plane, on the plane: each edge meets the plane in exactly one point.
struct Tip {
  unsigned corner;
  bool up;
};

inline Tip tip_of(Sides sides) {
  // Corners above the others: never none and never all, since neither side has all three.
  const unsigned upper = sides.above() != 0 ? sides.above() : kAllCorners ^ sides.below();
  const bool one = (upper & (upper - 1)) == 0;
  return {(one ? upper : kAllCorners ^ upper) >> 1, one};
}

inline unsigned next(unsigned corner) {
  return corner == 2 ? 0 : corner + 1;
}
inline unsigned previous(unsigned corner) {
  return corner == 0 ? 2 : corner - 1;
}

/// Whether the intervals in which two triangles meet the common line of their planes overlap.
/// Each triangle is mirrored where the other's tip is below, which orders both intervals alike.
[[gnu::noinline]] bool intervals_overlap(bool narrow, const PlacedTriangle& a, Sides of_a,
                                         const PlacedTriangle& b, Sides of_b) {
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

/// Whether a segment on both sides of the plane of `t`, or on it with one end, meets `t`.
[[gnu::noinline]] bool segment_meets(const PlacedTriangle& segment, Sides of_segment,
                                     const PlacedTriangle& t) {
  const unsigned tip = tip_of(of_segment).corner;
  bool left = false;
  bool right = false;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t turn = volume<int64_t>(segment.corner[tip], segment.corner[next(tip)],
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
  const auto u = onto.u;
  const auto v = onto.v;
  const int64_t area = static_cast<int64_t>(q.*u - p.*u) * (r.*v - p.*v) -
                       static_cast<int64_t>(q.*v - p.*v) * (r.*u - p.*u);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// The same of a triangle's corners.
[[gnu::noinline, gnu::cold]] int turn(const Projection& onto, const PlacedTriangle& t) {
  return turn(onto, t.corner[0], t.corner[1], t.corner[2]);
}

/// Whether some edge of `a`, in projection, has all of `b` strictly on its outer side. A projected
/// triangle without area has two outer sides.
[[gnu::noinline, gnu::cold]] bool edge_separates(const Projection& onto, const PlacedTriangle& a,
                                                 const PlacedTriangle& b) {
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
[[gnu::noinline, gnu::cold]] bool coplanar(const PlacedTriangle& a, const PlacedTriangle& b) {
  for (unsigned i = 1; i < 3; ++i) {
    for (unsigned j = 1; j < 3; ++j) {
      if (volume<int64_t>(a.corner[0], a.corner[i], b.corner[0], b.corner[j]) != 0) {
        return false;
      }
    }
  }
  return true;
}

/// Whether two triangles with overlapping boxes meet that lie in one plane or both lack area.
///
/// In two dimensions the normals of the edges and the two axes (the boxes) are all the separating
/// axes of segments, points and triangles. Coplanar triangles meet exactly if they do so in each
/// projection; one in which `a` keeps an area is one-to-one on their plane and decides alone.
[[gnu::noinline, gnu::cold]] bool flat_meet(const PlacedTriangle& a, const PlacedTriangle& b) {
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

/// Whether two triangles with overlapping boxes meet. `narrow`: no difference exceeds kMaxNarrow.
[[gnu::noinline]] bool meet(bool narrow, const PlacedTriangle& a, const PlacedTriangle& b) {
  const Sides of_a = sides_of(narrow, b, a);
  if (of_a.separate()) {
    return false;
  }
  const Sides of_b = sides_of(narrow, a, b);
  if (of_b.separate()) {
    return false;
  }
  if (!of_a.all_on_plane() && !of_b.all_on_plane()) {
    return intervals_overlap(narrow, a, of_a, b, of_b);
  }
  if (!of_a.all_on_plane()) {
    return segment_meets(a, of_a, b);
  }
  return of_b.all_on_plane() ? flat_meet(a, b) : segment_meets(b, of_b, a);
}

inline int32_t least(int32_t u, int32_t v) {
  return u < v ? u : v;
}
inline int32_t greatest(int32_t u, int32_t v) {
  return u > v ? u : v;
}

/// The extent of both triangles along an axis, or -1 where their boxes are apart.
inline int32_t extent(int32_t Point::*axis, const PlacedTriangle& a, const PlacedTriangle& b) {
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

}  // namespace

bool triangles_intersect(const PlacedTriangle& a, const PlacedTriangle& b) noexcept {
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
  return meet((x | y | z) <= kMaxNarrow, a, b);
}

}  // namespace flashbvh
