// Whether two transformed triangles have the same corners, in the same order.
#ifndef FLASHBVH_TESTS_SUPPORT_SAME_TRIANGLE_HPP
#define FLASHBVH_TESTS_SUPPORT_SAME_TRIANGLE_HPP

#include "flashbvh/detail/predicates/triangle.hpp"

namespace flashbvh::test {

inline bool same(const Triangle& t, const Triangle& u) {
  for (int i = 0; i < 3; ++i) {
    if (t.corner[i].x != u.corner[i].x || t.corner[i].y != u.corner[i].y ||
        t.corner[i].z != u.corner[i].z) {
      return false;
    }
  }
  return true;
}

}  // namespace flashbvh::test

#endif
