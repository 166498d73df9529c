// The oracle for a moving triangle: the first time at which two triangles touch, as a linear
// program whose answer comes with a proof.
//
// Triangle b moves by `way` from time 0 to 1. It first touches a at the least s for which
//   sum l_i a_i = sum m_j b_j + s way,  sum l_i = sum m_j = 1,  l, m >= 0,  0 <= s <= 1
// has a solution. As in triangle.hpp; phase two minimises s. Certificates:
// - never: a direction n along which b is strictly ahead of a at both ends of the motion
// - at s: weights l and m, that is, a common point at s; and, if s > 0, a direction along which b
//   is ahead of a by s times its retreat during the whole motion, so that they are apart before s
//
// Range: coordinate differences and `way` below 2^19. Minors have one more row than in
// triangle.hpp and expand to three of its minors: entries below 2^62.
#pragma once

#include "support/oracles/triangle.hpp"
#include "support/points.hpp"

#if defined(__SIZEOF_INT128__)

#include <algorithm>

namespace flashbvh::test {

/// The answer and its certificate. Check it with is_proven().
struct FirstTouch {
  bool touches;
  Wide time;  ///< the first time of contact, times `scale`
  Wide scale;
  Wide weight_a[3];  ///< of a common point at that time, times `scale`
  Wide weight_b[3];
  Wide direction[3];
};

/// Adds the columns of s and of its difference from 1, and the row of their sum.
using TouchTableau = Tableau<6, 8>;

/// Makes the artificial variables leave the basis; where one cannot, its row is zero.
inline void drive_out(TouchTableau& t) {
  for (int row = 0; row < TouchTableau::kRows; ++row) {
    for (int column = 0;
         t.basis[row] >= TouchTableau::kVariables && column < TouchTableau::kVariables; ++column) {
      if (t.entry[row][column] == 0) {
        continue;
      }
      const int sign = t.entry[row][column] < 0 ? -1 : 1;
      for (Wide& entry : t.entry[row]) {  // its right side is 0: either sign will do
        entry *= sign;
      }
      pivot(t, row, column);
    }
  }
}

inline FirstTouch first_touch(const Triangle& a, const Triangle& b, const Point& way) {
  constexpr int s = 6;
  constexpr int last = 5;
  auto t = start<TouchTableau>(a, b);
  for (int k = 0; k < 3; ++k) {
    t.entry[k][s] = -t.sign[k] * along(way, k);
  }
  t.entry[last][s] = t.entry[last][s + 1] = t.entry[last][TouchTableau::kRight] = 1;
  t.basis[last] = s + 1;
  FirstTouch found = {};
  found.touches = is_feasible(t);
  if (!found.touches) {
    get_direction(t, 1, found.direction);
    return found;
  }
  drive_out(t);
  auto& cost = t.entry[TouchTableau::kRows];
  for (int column = 0; column <= TouchTableau::kRight; ++column) {
    cost[column] = column == s ? t.scale : 0;
    for (int row = 0; row < TouchTableau::kRows; ++row) {
      cost[column] -= t.basis[row] == s ? t.entry[row][column] : 0;
    }
  }
  minimise(t);
  found.time = -cost[TouchTableau::kRight];
  found.scale = t.scale;
  get_weights(t, found.weight_a, found.weight_b);
  get_direction(t, 0, found.direction);
  return found;
}

/// Whether the weights describe one common point of a and b at the time of contact.
inline bool is_common_point(const FirstTouch& f, const Triangle& a, const Triangle& b,
                            const Point& way) {
  return f.time >= 0 && f.time <= f.scale &&
         f.weight_a[0] + f.weight_a[1] + f.weight_a[2] == f.scale &&
         is_common_point(f.weight_a, f.weight_b, a, b,
                         {f.time * way.x, f.time * way.y, f.time * way.z});
}

/// Whether the certificate proves the answer.
inline bool is_proven(const FirstTouch& f, const Triangle& a, const Triangle& b, const Point& way) {
  const Wide at_begin = ahead(f.direction, a, b);
  if (!f.touches) {
    return at_begin > 0 && ahead(f.direction, a, shifted(b, way)) > 0;
  }
  const Wide falls_back = -along(f.direction, way);
  return is_common_point(f, a, b, way) &&
         (f.time == 0 || (falls_back > 0 && at_begin * f.scale >= f.time * falls_back));
}

/// Whether two boxes may overlap before time `until` of a motion; exact up to 1e-12.
inline bool boxes_meet(const Triangle& a, const Triangle& b, const Point& way, double until) {
  double first = 0;
  double last = until;
  const auto keep = [&](double slope, double most) {  // slope t <= most
    if (slope == 0) {
      last = most < 0 ? -1 : last;
    } else if (slope > 0) {
      last = most / slope < last ? most / slope : last;
    } else {
      first = most / slope > first ? most / slope : first;
    }
  };
  for (int32_t Point::*axis : kPointAxes) {
    const auto ends = [axis](const Triangle& t) {
      return std::minmax({t.corner[0].*axis, t.corner[1].*axis, t.corner[2].*axis});
    };
    keep(way.*axis, ends(a).second - ends(b).first);
    keep(-1.0 * (way.*axis), ends(b).second - ends(a).first);
  }
  return first <= last + 1e-12;
}

}  // namespace flashbvh::test

#endif  // __SIZEOF_INT128__
