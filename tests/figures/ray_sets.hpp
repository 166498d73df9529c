// The rays behind the figures: aimed at a mesh's box from outside, and fans of rays from one point,
// like a sensor's scan. In integers alone, so that they are equal everywhere.
#pragma once

#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/ray.hpp"
#include "support/random.hpp"

namespace figures {

/// A mesh's box, in its frame.
struct Box {
  flashbvh::Point lower;
  flashbvh::Point upper;

  explicit Box(const flashbvh::Mesh& mesh) {
    const flashbvh::Box root = flashbvh::unpack(mesh.nodes[0].box);
    const int32_t(&o)[3] = mesh.origin;
    lower = {root.lower.x + o[0], root.lower.y + o[1], root.lower.z + o[2]};
    upper = {root.upper.x + o[0], root.upper.y + o[1], root.upper.z + o[2]};
  }
  flashbvh::Point middle() const {
    return {(lower.x + upper.x) / 2, (lower.y + upper.y) / 2, (lower.z + upper.z) / 2};
  }
  int32_t longest_side() const {
    const int32_t x = upper.x - lower.x;
    const int32_t y = upper.y - lower.y;
    const int32_t z = upper.z - lower.z;
    const int32_t of_xy = x < y ? y : x;
    return of_xy < z ? z : of_xy;
  }
  bool holds(const flashbvh::Point& p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y && lower.z <= p.z &&
           p.z <= upper.z;
  }
};

inline flashbvh::Point any_point(flashbvh::test::Random& random, const flashbvh::Point& lower,
                                 const flashbvh::Point& upper) {
  const int32_t x = random.between(lower.x, upper.x);
  const int32_t y = random.between(lower.y, upper.y);
  return {x, y, random.between(lower.z, upper.z)};
}

/// A segment through `by` and equally far beyond it.
inline flashbvh::Segment through(const flashbvh::Point& from, const flashbvh::Point& by) {
  return {from, {2 * by.x - from.x, 2 * by.y - from.y, 2 * by.z - from.z}};
}

/// A random segment from outside the box, within two of its longest sides, through a point of it.
inline flashbvh::Segment any_aimed(flashbvh::test::Random& random, const Box& box) {
  const int32_t reach = 2 * box.longest_side();
  const flashbvh::Point m = box.middle();
  flashbvh::Point from = m;
  while (box.holds(from)) {
    from = any_point(random, {m.x - reach, m.y - reach, m.z - reach},
                     {m.x + reach, m.y + reach, m.z + reach});
  }
  return through(from, any_point(random, box.lower, box.upper));
}

/// Rays in rows, 45 degrees wide and high.
struct Fan {
  const char* name;
  int32_t rows;
  int32_t columns;
};

/// A ray of a fan whose origin lies one longest side away along each axis, in direction (1, 1, -1);
/// rows run along (1, -1, 0), columns along (1, 1, 2).
inline flashbvh::Segment of_fan(const Fan& fan, const Box& box, int32_t row, int32_t column) {
  const int32_t side = box.longest_side();
  const flashbvh::Point m = box.middle();
  const int32_t along = side * (2 * column - fan.columns + 1) / (2 * fan.columns);
  const int32_t up = side * 7 / 24 * (2 * row - fan.rows + 1) / fan.rows;
  return through({m.x - side, m.y - side, m.z + side},
                 {m.x + along + up, m.y - along + up, m.z + 2 * up});
}

}  // namespace figures
