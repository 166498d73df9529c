// How far queries round a placed vertex.
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

/// 0.89 cells, in 1/256 cell, rounded up. A placed vertex is rounded to whole cells, and its
/// rotation to 2^-23, which moves it by less than 0.01 cells: 0.51 along three axes, 0.8833.
constexpr uint32_t kVertexRounding = 228;

/// The rounding in 1/65,536 cell if the coordinates of the mesh's origin add up to `sum` cells,
/// below 2^33. The rotation turns the origin, too, so each axis is off by 2^-23 of `sum` more. 0.89
/// cells include 32,000 cells.
constexpr uint32_t vertex_rounding(uint64_t sum) {
  constexpr uint32_t near_by = 58328;
  const auto at_origin = static_cast<uint32_t>(57892 + (sum * 222 >> 14));  // sqrt(3) / 2^7 of it
  return at_origin > near_by ? at_origin : near_by;
}

}  // namespace flashbvh::detail
