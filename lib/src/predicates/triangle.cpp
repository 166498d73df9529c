// Triangle against triangle, decided by the signs of integer determinants.
//
// General case: Guigue and Devillers 2003. Two triangles that cross each other's plane intersect
// the line common to both planes in one interval each; two determinants decide whether these
// overlap.
//
// Everything else is degenerate. The sides of the planes alone distinguish the cases, since a
// triangle without area has no plane and leaves every point on side zero:
// - all six corners in one plane, or both triangles without area: separating axes in projections
// - a segment that crosses the plane of a triangle: the signs of its line about the three edges
//
// Invariant: only differences of corners are multiplied, so their position never matters. Each
// value whose sign is taken is exact.
#include "flashbvh/detail/predicates/triangle.hpp"

#include "flashbvh/detail/arch/inline.hpp"
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
/// A cross product of differences up to kMaxDifference.
struct Wide {
  int64_t x;
  int64_t y;
  int64_t z;
};

/// Six times the volume of p, q, r, s. Inlined for narrow edges, as nearly all are.
FLASHBVH_INLINE inline int64_t volume_of(Narrow, const Point& p, const Point& q, const Point& r,
                                         const Point& s) {
  return dot(cross<Narrow>(difference(s, r), difference(q, p)), difference(r, p));
}
inline int64_t volume_of(Wide, const Point& p, const Point& q, const Point& r, const Point& s) {
  return volume<Wide>(p, q, r, s);
}

/// Corners of a triangle above a plane: bit i for corner i. No bit is set if all corners lie on the
/// plane; all bits are set if all corners lie strictly on one side. Otherwise a corner on the plane
/// counts as above it if one is below.
using Upper = unsigned;
constexpr Upper kSeparated = kAllCorners;

/// `height`: of the corners, in any unit.
FLASHBVH_INLINE_FOR_SPEED inline Upper upper_of(const int64_t (&height)[3]) {
  const auto bits = [](bool first, bool second, bool third) {
    return (first ? 1u : 0u) | (second ? 2u : 0u) | (third ? 4u : 0u);
  };
  const unsigned below = bits(height[0] < 0, height[1] < 0, height[2] < 0);
  if (below == 0) {
    return bits(height[0] > 0, height[1] > 0, height[2] > 0);
  }
  return below == kAllCorners ? kSeparated : kAllCorners ^ below;
}

/// `origin`: a point of the plane.
inline Upper upper_of_normal(const Narrow& normal, const Point& origin, const Triangle& tested) {
  const auto height = [&](const Point& corner) { return dot(normal, difference(corner, origin)); };
  return upper_of({height(tested.corner[0]), height(tested.corner[1]), height(tested.corner[2])});
}
/// Computes one height at a time: three of 64 bits would take more stack than everything else.
template <class Height>
inline Upper upper_of(const Height& height, const Triangle& tested) {
  unsigned below = 0;
  unsigned above = 0;
  for (unsigned i = 3; i-- != 0;) {
    const int64_t at = height(tested.corner[i]);
    below = below << 1 | (at < 0 ? 1u : 0u);
    above = above << 1 | (at > 0 ? 1u : 0u);
  }
  return below == 0 ? above : below == kAllCorners ? kSeparated : kAllCorners ^ below;
}

template <class Cofactors>
[[gnu::noinline]] Upper upper_of_plane(const Triangle& plane, const Triangle& tested) {
  return upper_of_normal(normal_of<Cofactors>(plane), plane.corner[0], tested);
}
/// If optimised for size, reuses the code of volumes: wide triangles are rare.
template <>
[[gnu::noinline]] Upper upper_of_plane<Wide>(const Triangle& plane, const Triangle& tested) {
  const Point(&p)[3] = plane.corner;
#if defined(__OPTIMIZE_SIZE__)
  const auto height = [&](const Point& corner) { return volume<Wide>(p[0], p[1], p[2], corner); };
#else
  const Wide normal = normal_of<Wide>(plane);
  const auto height = [&](const Point& corner) { return dot(normal, difference(corner, p[0])); };
#endif
  return upper_of(height, tested);
}

inline Upper upper_of(bool narrow, const Triangle& plane, const Triangle& tested) {
  return narrow ? upper_of_plane<Narrow>(plane, tested) : upper_of_plane<Wide>(plane, tested);
}

/// A corner's offset in a triangle, in bytes.
using Place = uint8_t;
constexpr Place kFirst = 0;
constexpr Place kSecond = sizeof(Point);
constexpr Place kThird = 2 * sizeof(Point);

inline const Point& corner_at(const Triangle& t, Place place) {
  return *reinterpret_cast<const Point*>(reinterpret_cast<const char*>(t.corner) + place);
}

/// The tip of a triangle, the corner alone on its side of a plane, by Upper. Both edges from it end
/// strictly on the other side or, unless it is itself on the plane, on the plane: each edge
/// intersects the plane in exactly one point.
struct Fan {
  Place tip;
  bool up;
  Place others[3];  ///< the previous, the next and the previous corner
};
constexpr Fan kFans[kAllCorners] = {{},
                                    {kFirst, true, {kThird, kSecond, kThird}},
                                    {kSecond, true, {kFirst, kThird, kFirst}},
                                    {kThird, false, {kSecond, kFirst, kSecond}},
                                    {kThird, true, {kSecond, kFirst, kSecond}},
                                    {kSecond, false, {kFirst, kThird, kFirst}},
                                    {kFirst, false, {kThird, kSecond, kThird}}};

/// Returns whether the intervals of two triangles on the common line of their planes overlap.
/// A triangle is mirrored if the other's tip is below, which orders both intervals alike.
template <class Cofactors>
[[gnu::noinline]] bool intervals_overlap(const Triangle& a, const Triangle& b, Upper of_a,
                                         Upper of_b) {
  const Fan& fan_a = kFans[of_a];
  const Fan& fan_b = kFans[of_b];
  const Place* const others_a = fan_a.others + fan_b.up;
  const Place* const others_b = fan_b.others + fan_a.up;
  const Point& tip_a = corner_at(a, fan_a.tip);
  const Point& tip_b = corner_at(b, fan_b.tip);
  const auto volume = [&](unsigned i) {
    return volume_of(Cofactors(), tip_a, corner_at(a, others_a[i]), tip_b,
                     corner_at(b, others_b[i]));
  };
  return volume(0) <= 0 && volume(1) >= 0;
}

/// Whether a segment on both sides of the plane of `t`, or on it with one end, intersects `t`.
[[gnu::noinline]] bool segment_intersects(const Triangle& segment, Upper of_segment,
                                          const Triangle& t) {
  const Fan& fan = kFans[of_segment];
  const Point& from = corner_at(segment, fan.tip);
  const Point& to = corner_at(segment, fan.others[1]);
  bool left = false;
  bool right = false;
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t turn = detail::volume<Wide>(from, to, t.corner[i], t.corner[next(i)]);
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

/// turn() of a triangle's corners.
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

/// Tests triangles that lie in one plane or both lack area, and whose boxes overlap.
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

/// Tests triangles of which one lies in the other's plane or lacks area, and whose boxes overlap.
[[gnu::noinline, gnu::cold]] bool flat_or_segment_intersect(const Triangle& a, const Triangle& b,
                                                            Upper of_a, Upper of_b) {
  if (of_a != 0) {
    return segment_intersects(a, of_a, b);
  }
  return of_b == 0 ? flat_intersect(a, b) : segment_intersects(b, of_b, a);
}

/// Whether two triangles with overlapping boxes intersect. `narrow`: no edge exceeds kMaxNarrow.
[[gnu::noinline]] bool intersect(bool narrow, const Triangle& a, const Triangle& b) {
  const Upper of_a = upper_of(narrow, b, a);
  if (of_a == kSeparated) {
    return false;
  }
  const Upper of_b = upper_of(narrow, a, b);
  if (of_b == kSeparated) {
    return false;
  }
  if (of_a == 0 || of_b == 0) {
    return flat_or_segment_intersect(a, b, of_a, of_b);
  }
  return narrow ? intervals_overlap<Narrow>(a, b, of_a, of_b)
                : intervals_overlap<Wide>(a, b, of_a, of_b);
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

bool near_triangles_intersect(const Triangle& a, const Triangle& b,
                              const PlaneNormal& normal_b) noexcept {
  const Upper of_a = upper_of_normal(normal_b, b.corner[0], a);
  if (of_a == kSeparated) {
    return false;
  }
  const Upper of_b = upper_of_plane<Narrow>(a, b);
  if (of_b == kSeparated) {
    return false;
  }
  if (of_a == 0 || of_b == 0) {
    return boxes_overlap(a, b) && flat_or_segment_intersect(a, b, of_a, of_b);
  }
  return intervals_overlap<Narrow>(a, b, of_a, of_b);
}

bool wide_triangles_intersect(const Triangle& a, const Triangle& b) noexcept {
  return boxes_overlap(a, b) && intersect(/*narrow=*/false, a, b);
}

/// If they do not overlap, all three corners lie beyond one of the box's sides.
bool box_overlaps(const PackedBox& box, const Triangle& t) noexcept {
  const Point(&p)[3] = t.corner;
  int32_t unbiased = -kBoundBias;
#if defined(__GNUC__)
  __asm__("" : "+r"(unbiased));  // added while a half is unpacked
#endif
  const auto apart = [unbiased](uint32_t upper, uint32_t negated_lower, int32_t u, int32_t v,
                                int32_t w) {
    const int32_t above = unbiased + static_cast<int32_t>(upper);
    const int32_t negated_below = unbiased + static_cast<int32_t>(negated_lower);
    return (((above - u) & (above - v) & (above - w)) |
            ((negated_below + u) & (negated_below + v) & (negated_below + w))) < 0;
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
