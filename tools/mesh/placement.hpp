// Placements of meshes in scenes.
#pragma once

#include <array>
#include <cstddef>

namespace flashbvh::tool {

/// Rows of a rotation and scale with a translation, in double precision: placing a mesh adds no
/// rounding that matters.
using Placement = std::array<std::array<double, 4>, 3>;

constexpr Placement kIdentity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// `inner`, then `outer`.
inline Placement composed(const Placement& outer, const Placement& inner) {
  Placement product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      product[row][column] = column == 3 ? outer[row][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        product[row][column] += outer[row][k] * inner[k][column];
      }
    }
  }
  return product;
}

inline bool is_mirrored(const Placement& p) {
  return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
             p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
             p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]) <
         0;
}

}  // namespace flashbvh::tool
