// Ranks: the order in which `ranked` descends.
#ifndef FLASHBVH_TOOLS_BAKE_RANK_HPP
#define FLASHBVH_TOOLS_BAKE_RANK_HPP

#include <cstdint>

#include "flashbvh/box.hpp"

namespace flashbvh::bake {

/// A box's size on a logarithmic scale of eight steps an octave: 1 (a point) to 116. It never grows
/// from a box to one inside it. The size is the sum of the three extents.
constexpr std::uint32_t rank_of(const Box& box) {
  const auto size = static_cast<std::uint32_t>(
      (box.upper.x - box.lower.x) + (box.upper.y - box.lower.y) + (box.upper.z - box.lower.z));
  std::uint32_t shift = 0;
  while ((size >> shift) >= 16) {
    ++shift;
  }
  // Below 16 the size itself; above, its four leading bits behind eight for each octave.
  return 1 + shift * 8 + (size >> shift);
}

}  // namespace flashbvh::bake

#endif
