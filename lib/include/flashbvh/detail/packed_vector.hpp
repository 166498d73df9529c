// Vectors whose x and y lie in one word, for cores that multiply two halves at once.
#ifndef FLASHBVH_DETAIL_PACKED_VECTOR_HPP
#define FLASHBVH_DETAIL_PACKED_VECTOR_HPP

#include <stdint.h>

#include "flashbvh/detail/packed_multiply.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// Three signed halves.
struct PackedVector {
  uint32_t xy;  ///< x low, y high
  int32_t z;

  static PackedVector of(const Vertex& v) {
    return {join_halves(static_cast<uint16_t>(v.x), static_cast<uint16_t>(v.y)), v.z};
  }
};

}  // namespace flashbvh::detail

#endif
