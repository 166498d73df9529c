// Random pairs of triangles, by the cases of the exact test, which differ in cost.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/predicates/triangle.hpp"
#include "support/points.hpp"

namespace flashbvh::test {

/// Changes a pair of random triangles into one of its kind.
using AdaptPair = void (*)(Triangle& a, Triangle& b);

inline void set_boxes_disjoint(Triangle&, Triangle& b) {
  for (Point& corner : b.corner) {
    corner.z += 16001;
  }
}

inline void set_general(Triangle&, Triangle&) {}

inline void set_coplanar(Triangle& a, Triangle& b) {
  for (int i = 0; i < 3; ++i) {
    a.corner[i].z = a.corner[i].x + a.corner[i].y;
    b.corner[i].z = b.corner[i].x + b.corner[i].y;
  }
}

inline void set_segments(Triangle& a, Triangle& b) {
  a.corner[2] = a.corner[1];
  b.corner[2] = b.corner[1];
}

struct TriangleKind {
  const char* name;
  AdaptPair adapt;
};

inline constexpr TriangleKind kBoxesDisjoint = {"boxes_disjoint", set_boxes_disjoint};
inline constexpr TriangleKind kGeneral = {"general", set_general};
inline constexpr TriangleKind kCoplanar = {"coplanar", set_coplanar};
inline constexpr TriangleKind kSegments = {"segments", set_segments};
inline constexpr TriangleKind kTriangleKinds[] = {kBoxesDisjoint, kGeneral, kCoplanar, kSegments};

inline void set_random_pair(Random& random, const TriangleKind& kind, Triangle& a, Triangle& b) {
  constexpr int32_t kReach = 8000;  // differences below 2^15
  for (int i = 0; i < 3; ++i) {
    a.corner[i] = any_point(random, kReach);
    b.corner[i] = any_point(random, kReach);
  }
  kind.adapt(a, b);
}

}  // namespace flashbvh::test
