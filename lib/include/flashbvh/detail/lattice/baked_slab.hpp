// A baked slab of a leaf, as sums of products take it.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// Bits of a direction's largest component, without its sign. With one more bit, sums with an
/// offset and biases would leave 32 bits.
constexpr unsigned kDirectionBits = 13;

/// The products of a direction, within +-8,128, with coordinates: within +-2^29.
struct BakedSlab {
  PackedVector direction;
  int32_t least;  ///< of the leaf's triangles along the direction
  int32_t most;

  FLASHBVH_INLINE static BakedSlab of(const LeafSlabs& slabs, int which) {
    const LeafSlabs::Direction& d = slabs.of[which];
    constexpr int scale = 1 << (kDirectionBits - 7);
    const int32_t least = slabs.least[which] * (1 << kSlabUnitBits);
    const uint32_t thickness = (d.thickness & 31u) << (kSlabUnitBits + 2 * (d.thickness >> 5));
    return {{join_halves(static_cast<uint16_t>(d.x * scale), static_cast<uint16_t>(d.y * scale)),
             d.z * scale},
            least,
            least + static_cast<int32_t>(thickness)};
  }
};

}  // namespace flashbvh::detail
