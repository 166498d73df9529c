// Every pair of triangles of two meshes, as a query has them.
#ifndef FLASHBVH_TESTS_SUPPORT_PAIRS_OF_TRIANGLES_HPP
#define FLASHBVH_TESTS_SUPPORT_PAIRS_OF_TRIANGLES_HPP

#include <stdint.h>

#include "flashbvh/detail/bounds/transform.hpp"

namespace flashbvh::test {

/// `visit(i, j, of_a, of_b)`: by their positions, in A's lattice.
template <class Mesh, class Visit>
void for_all_pairs(const Mesh& a, const Mesh& b, const detail::Transform& transform,
                   const Visit& visit) {
  for (uint32_t i = 0; i < a.triangle_count; ++i) {
    Triangle of_a;
    detail::translate_triangle(a, i, detail::kNoOffset, of_a);
    for (uint32_t j = 0; j < b.triangle_count; ++j) {
      Triangle of_b;
      detail::transform_triangle(b, j, transform, of_b);
      visit(i, j, of_a, of_b);
    }
  }
}

}  // namespace flashbvh::test

#endif
