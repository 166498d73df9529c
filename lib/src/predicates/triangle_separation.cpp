// Tests whether two triangles are no nearer than a limit, without computing their distance.
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "triangle_range.hpp"

namespace flashbvh::detail {
namespace {

/// Returns whether all of `other` lies on one side of the plane of `face`, at a squared distance of
/// at least `limit` + 1.
[[gnu::noinline]] bool plane_separates(const Triangle& face, const Triangle& other, int64_t limit) {
  const LongVector n = normal_of<LongVector>(face);
  const auto height = [&](int i) {
    return detail::dot(n, difference(other.corner[i], face.corner[0]));
  };
  const int64_t p = height(0);
  const int64_t q = height(1);
  const int64_t r = height(2);
  if ((p ^ q) < 0 || (p ^ r) < 0) {
    return false;
  }
  const auto size = [](int64_t value) { return static_cast<uint64_t>(value < 0 ? -value : value); };
  const uint64_t first = size(p) < size(q) ? size(p) : size(q);
  const uint64_t least = first < size(r) ? first : size(r);
  // 13 bits per component, rounded up, so that squares and products with the limit fit 64 bits.
  const uint64_t all = size(n.x) | size(n.y) | size(n.z) | 1;
  const int bits = 64 - __builtin_clzll(all);
  const int down = bits > 13 ? bits - 13 : 0;
  const auto square = [&](int64_t component) {
    const uint64_t up = (size(component) >> down) + (down != 0 ? 1 : 0);
    return up * up;
  };
  const uint64_t squared = square(n.x) + square(n.y) + square(n.z);
  const uint64_t distance = least >> down;
  // A distance of 0, or a triangle without a plane, decides nothing.
  return distance != 0 && distance * distance >= static_cast<uint64_t>(limit + 1) * squared;
}

inline uint32_t size_of(int32_t value) {
  return value < 0 ? 0u - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
}

inline int32_t short_dot(const Vector& u, const Vector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// The first corner along a direction, and its position there relative to `from`.
struct Support {
  unsigned corner;
  int32_t at;
};
inline Support first_along(const Vector& direction, const Triangle& t, const Point& from) {
  Support first = {0, short_dot(direction, difference(t.corner[0], from))};
  for (unsigned i = 1; i < 3; ++i) {
    const int32_t at = short_dot(direction, difference(t.corner[i], from));
    if (at < first.at) {
      first = {i, at};
    }
  }
  return first;
}

/// The gap from A to B along a direction, and the corners that face each other.
struct GapAlong {
  unsigned of_a;
  unsigned of_b;
  int32_t gap;
  uint32_t squared_length;  ///< the direction's

  /// Returns whether the gap proves a squared distance above `limit`.
  bool is_above(int64_t limit) const {
    return gap > 0 && static_cast<uint64_t>(gap) * static_cast<uint32_t>(gap) >=
                          static_cast<uint64_t>(limit + 1) * squared_length;
  }
};
inline GapAlong gap_along(const Vector& direction, const Triangle& a, const Triangle& b) {
  const Support of_b = first_along(direction, b, a.corner[0]);
  const Support of_a = first_along(negated(direction), a, a.corner[0]);
  return {of_a.corner, of_b.corner, of_b.at + of_a.at,
          static_cast<uint32_t>(short_dot(direction, direction))};
}

/// Cuts a direction to 12 bits, so that its dot products with differences fit 32 bits.
inline Vector direction_of(const Vector& v) {
  const uint32_t all = size_of(v.x) | size_of(v.y) | size_of(v.z) | 1u;
  const int bits = 32 - __builtin_clz(all);
  const int down = bits > 12 ? bits - 12 : 0;
  return {v.x >> down, v.y >> down, v.z >> down};
}

inline Vector direction_across(const LongVector& v) {
  const auto size = [](int64_t value) { return static_cast<uint64_t>(value < 0 ? -value : value); };
  const int bits = 64 - __builtin_clzll(size(v.x) | size(v.y) | size(v.z) | 1);
  const int down = bits > 12 ? bits - 12 : 0;
  const auto scaled = [down](int64_t value) { return static_cast<int32_t>(value >> down); };
  return {scaled(v.x), scaled(v.y), scaled(v.z)};
}

/// The edge with the largest sum of components' magnitudes; the first one on a tie.
inline Vector longest_edge(const Triangle& t) {
  const auto length = [](const Vector& v) { return size_of(v.x) + size_of(v.y) + size_of(v.z); };
  const auto longer = [&](const Vector& u, const Vector& v) {
    return length(v) > length(u) ? v : u;
  };
  const Vector first = difference(t.corner[1], t.corner[0]);
  const Vector second = difference(t.corner[2], t.corner[1]);
  return longer(longer(first, second), difference(t.corner[0], t.corner[2]));
}

/// Signed gap from A's box to B's along an axis: negative if B's is below, 0 if they overlap.
inline int32_t box_gap(const Triangle& a, const Triangle& b, int32_t Point::*axis) {
  const Range of_a = range_of(a, axis);
  const Range of_b = range_of(b, axis);
  const int32_t above = of_b.least - of_a.most;
  const int32_t below = of_b.most - of_a.least;
  return above > 0 ? above : below < 0 ? below : 0;
}

/// Packs a direction; its largest component keeps 9 bits and a sign. Any direction is a safe test.
inline Direction packed(const Vector& v) {
  const uint32_t all = size_of(v.x) | size_of(v.y) | size_of(v.z) | 1u;
  const int top = __builtin_clz(all) - 1;  // bits that are free below the sign
  const auto bits = [top](int32_t component) {
    return static_cast<uint32_t>(static_cast<int32_t>(static_cast<uint32_t>(component) << top) >>
                                 22) &
           1023u;
  };
  return {bits(v.x) | bits(v.y) << 10 | bits(v.z) << 20};
}
inline Vector unpacked(const Direction& direction) {
  const auto component = [&](int shift) {
    return static_cast<int32_t>(direction.packed << shift) >> 22;
  };
  return {component(22), component(12), component(2)};
}

/// The point of the segment from `v` to `s` nearest to 0, cut to whole cells; `v` if that is it.
inline Vector nearest_between(const Vector& v, const Vector& s) {
  const Vector back = {v.x - s.x, v.y - s.y, v.z - s.z};
  const int64_t part = dot(v, back);
  const int64_t whole = dot(back, back);
  if (part <= 0) {
    return v;
  }
  if (part >= whole) {
    return s;
  }
  // The share has 12 fraction bits; numerator and denominator are cut to 19 bits.
  const int bits = 64 - __builtin_clzll(static_cast<uint64_t>(whole));
  const int down = bits > 19 ? bits - 19 : 0;
  const auto share = static_cast<int32_t>((static_cast<uint32_t>(part >> down) << 12) /
                                          static_cast<uint32_t>(whole >> down));
  return {v.x - (back.x * share >> 12), v.y - (back.y * share >> 12), v.z - (back.z * share >> 12)};
}

}  // namespace

int64_t squared_box_gap(const Triangle& a, const Triangle& b) noexcept {
  const auto squared = [&](int32_t Point::*axis) {
    const int64_t gap = box_gap(a, b, axis);
    return gap * gap;
  };
  return squared(&Point::x) + squared(&Point::y) + squared(&Point::z);
}

bool boxes_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept {
  const Vector gap = {box_gap(a, b, &Point::x), box_gap(a, b, &Point::y), box_gap(a, b, &Point::z)};
  if (dot(gap, gap) <= limit) {
    return false;
  }
  direction = packed(direction_of(gap));
  return true;
}

bool directions_separate(const Triangle& a, const Triangle& b, int64_t limit,
                         Direction& first) noexcept {
  constexpr int kMostSteps = 6;
  // The direction that separated the last pair often separates its neighbours.
  if (gap_along(unpacked(first), a, b).is_above(limit)) {
    return true;
  }
  Vector v = difference(b.corner[0], a.corner[0]);
  for (int step = 0;; ++step) {
    const Vector d = direction_of(v);
    const GapAlong gap = gap_along(d, a, b);
    if (gap.is_above(limit)) {
      first = packed(d);
      return true;
    }
    if (step == kMostSteps - 1) {
      return false;
    }
    const Vector to = nearest_between(v, difference(b.corner[gap.of_b], a.corner[gap.of_a]));
    if (to.x == v.x && to.y == v.y && to.z == v.z) {
      return false;
    }
    v = to;
  }
}

bool edges_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept {
  Vector d = direction_across(cross<LongVector>(longest_edge(a), longest_edge(b)));
  if (gap_along(d, a, b).gap <= 0) {
    d = negated(d);
  }
  if (!gap_along(d, a, b).is_above(limit)) {
    return false;
  }
  direction = packed(d);
  return true;
}

bool middles_separate(const Triangle& a, const Triangle& b) noexcept {
  const auto from_a_to_b = [&](int32_t Point::*axis) {
    const auto sum = [axis](const Triangle& t) {
      return t.corner[0].*axis + t.corner[1].*axis + t.corner[2].*axis;
    };
    return sum(b) - sum(a);
  };
  const Vector d =
      direction_of({from_a_to_b(&Point::x), from_a_to_b(&Point::y), from_a_to_b(&Point::z)});
  const Point& from = a.corner[0];
  const auto along = [&](const Point& corner) { return short_dot(d, difference(corner, from)); };
  const auto lesser = [](int32_t u, int32_t v) { return u < v ? u : v; };
  const int32_t of_b = lesser(lesser(along(b.corner[0]), along(b.corner[1])), along(b.corner[2]));
  // A's first corner is at 0.
  return of_b > 0 && along(a.corner[1]) < of_b && along(a.corner[2]) < of_b;
}

bool planes_separate(const Triangle& a, const Triangle& b, int64_t limit) noexcept {
  return plane_separates(a, b, limit) || plane_separates(b, a, limit);
}

}  // namespace flashbvh::detail
