// Random pairs of triangles as queries report them: of every kind, many of them intersecting.
#pragma once

#include <stdint.h>

#include <initializer_list>

#include "support/points.hpp"

namespace flashbvh::test {

struct TransformedPair {
  Triangle a;
  Triangle b;
};

/// A point within [0, size] on each axis; a third of its coordinates lies at the limits.
inline Point point_within(Random& random, int32_t size) {
  const auto coordinate = [&] {
    return random.below(3) != 0 ? random.between(0, size) : random.below(2) != 0 ? size : 0;
  };
  const int32_t x = coordinate();
  const int32_t y = coordinate();
  return {x, y, coordinate()};
}

/// A triangle, sometimes a segment or a point.
inline Triangle triangle_within(Random& random, int32_t size) {
  Triangle t;
  for (Point& corner : t.corner) {
    corner = point_within(random, size);
  }
  const uint32_t shape = random.below(10);
  if (shape < 2) {
    t.corner[1 + shape] = t.corner[0];
  } else if (shape == 2) {
    t.corner[1] = t.corner[2] = t.corner[0];
  }
  return t;
}

/// Two triangles in one plane or on one line, made of steps u and v from one origin: nested,
/// overlapping, touching along edges or at corners, or disjoint.
inline TransformedPair coplanar_pair(Random& random, int32_t size) {
  const int32_t step = size / 24 > 0 ? size / 24 : 1;
  const Point o = point_within(random, step);
  const Point u = point_within(random, step);
  const Point v = point_within(random, step);
  const int32_t most = random.below(2) != 0 ? 11 : 3;
  const int32_t line = random.below(5) == 0 ? 0 : most;
  TransformedPair pair;
  for (Triangle* t : {&pair.a, &pair.b}) {
    for (Point& corner : t->corner) {
      const Point along_u = scaled(random.between(0, most), u);
      corner = sum(o, sum(along_u, scaled(random.between(0, line), v)));
    }
  }
  return pair;
}

/// `a` has a point in its face, on an edge or at a corner. This point is a corner of `b`, lies on
/// an edge of `b`, or is the middle of a segment b.
inline TransformedPair touching_pair(Random& random, int32_t size) {
  const int32_t step = size / 12 > 0 ? size / 12 : 1;
  const Point o = sum(point_within(random, step), {4 * step, 4 * step, 4 * step});
  const Point u = point_within(random, step);
  const Point v = point_within(random, step);
  const Point w = point_within(random, step);
  const int32_t i = random.between(0, 4);
  const Point common = sum(o, sum(scaled(i, u), scaled(random.between(0, 4 - i), v)));
  const Point start = sum(common, scaled(-random.between(0, 2), w));
  const Point end = sum(common, scaled(random.between(0, 2), w));
  const Point third = random.below(4) == 0 ? common : point_within(random, size);
  return {{{o, sum(o, scaled(4, u)), sum(o, scaled(4, v))}}, {{start, end, third}}};
}

/// Two edges that cross in p + w * k / n: n divides both; one is w long and one w + n * v. At odd
/// multiples of 1/512, the rounded result depends on the edge from which it starts.
inline TransformedPair crossing_edges_pair(Random& random) {
  constexpr int32_t parts[] = {2, 3, 512, 512, 1536};
  const int32_t n = random.one_of(parts);
  const int32_t k = random.between(1, n - 1);
  const Point p = point_within(random, 100);
  const Point w = point_within(random, 20000);
  const int32_t most = 20000 / n < 40 ? 20000 / n : 40;
  const Point up = point_within(random, 2 * most);
  const Point v = {up.x - most, up.y - most, up.z - most};
  const Point q = sum(p, w);
  const Point r = sum(p, scaled(-k, v));
  const Point s = sum(q, scaled(n - k, v));
  const bool flat = random.below(3) == 0;
  return {{{p, q, flat ? q : point_within(random, 30000)}},
          {{r, s, flat ? r : point_within(random, 30000)}}};
}

/// `b` around a corner of `a`, or with a corner there: the pair spans up to twice a triangle.
inline TransformedPair neighbours(Random& random, int32_t size) {
  TransformedPair pair = {triangle_within(random, size), triangle_within(random, size)};
  const Point* const b = pair.b.corner;
  const Point inner = {(b[0].x + b[1].x + b[2].x) / 3, (b[0].y + b[1].y + b[2].y) / 3,
                       (b[0].z + b[1].z + b[2].z) / 3};
  const Point from = random.below(4) == 0 ? b[0] : inner;
  pair.b = shifted(pair.b, sum(pair.a.corner[0], scaled(-1, from)));
  return pair;
}

/// A pair of any kind, with a size and coordinates in the range of contact_of().
inline TransformedPair any_pair(Random& random) {
  constexpr int32_t sizes[] = {1, 2, 3, 5, 24, 255, 1000, 20000, kMaxContactSpan};
  const int32_t size = random.one_of(sizes);
  switch (random.below(8)) {
    case 0:
      return coplanar_pair(random, size);
    case 1:
      return touching_pair(random, size >= 12 ? size : 12);
    case 2:
      return crossing_edges_pair(random);
    case 3:
    case 4:
      return neighbours(random, size);
    default: {
      TransformedPair pair = {triangle_within(random, size), triangle_within(random, size)};
      const uint32_t shared = random.below(6);
      for (uint32_t i = 0; i < shared && i < 3 && shared < 3; ++i) {
        pair.b.corner[i] = pair.a.corner[i];
      }
      return pair;
    }
  }
}

/// The pair translated to a random point in the range of contact_of(), sometimes to its limits.
inline TransformedPair translated_anywhere(Random& random, const TransformedPair& pair) {
  Point by = {0, 0, 0};
  for (int32_t Point::*axis : kPointAxes) {
    int32_t low = INT32_MAX;
    int32_t high = INT32_MIN;
    for (const Triangle* t : {&pair.a, &pair.b}) {
      for (const Point& corner : t->corner) {
        low = corner.*axis < low ? corner.*axis : low;
        high = corner.*axis > high ? corner.*axis : high;
      }
    }
    const int32_t least = -kMaxContactCoordinate - low;
    const int32_t most = kMaxContactCoordinate - high;
    by.*axis = random.below(4) == 0 ? least : random.between(least, most);
  }
  return {shifted(pair.a, by), shifted(pair.b, by)};
}

}  // namespace flashbvh::test
