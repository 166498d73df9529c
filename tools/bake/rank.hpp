// Ranks: the order in which `ranked` descends.
#ifndef FLASHBVH_TOOLS_BAKE_RANK_HPP
#define FLASHBVH_TOOLS_BAKE_RANK_HPP

#include <cstdint>

#include "flashbvh/box.hpp"

namespace flashbvh::bake {

/// What `ranked` takes for a box's size: its three extents and the shortest of them once more, in
/// cells. Below 2^17; never larger for a box inside another.
constexpr std::uint32_t rank_measure(const Box& box) {
  const std::int32_t x = box.upper.x - box.lower.x;
  const std::int32_t y = box.upper.y - box.lower.y;
  const std::int32_t z = box.upper.z - box.lower.z;
  const std::int32_t shorter = x < y ? x : y;
  return static_cast<std::uint32_t>(x + y + z + (shorter < z ? shorter : z));
}

/// A measure on a logarithmic scale of eight steps an octave: 1 (nothing) to 120. Monotone.
/// Below 16 the measure itself; above, its four leading bits behind eight for each octave.
constexpr std::uint32_t rank_on_scale(std::uint32_t measure) {
  std::uint32_t shift = 0;
  while ((measure >> shift) >= 16) {
    ++shift;
  }
  return 1 + shift * 8 + (measure >> shift);
}

/// Of an internal node with this box, before baking clamps it to its parent's.
constexpr std::uint32_t rank_of(const Box& box) {
  return rank_on_scale(rank_measure(box));
}

}  // namespace flashbvh::bake

#endif
