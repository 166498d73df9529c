// Two triangles, placed finer than the lattice: what decides how far bodies are apart on their way.
#ifndef FLASHBVH_MOTION_FINE_PAIR_HPP
#define FLASHBVH_MOTION_FINE_PAIR_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/frame.hpp"
#include "flashbvh/mesh.hpp"

namespace flashbvh::detail {

/// Of A and B by their positions, B's frame being in A's. Corners are counted from A's first one,
/// in 2^-bits cell, and B's are rounded to it: as finely as is needed to compare them with a
/// distance, in 1/256 cell, of which `within` is not what they move.
struct FinePair {
  Triangle a;
  Triangle b;
  uint8_t bits;  ///< 4; less for large distances, and of large triangles
};

/// From here on distances need not be fine, in 1/256 cell.
constexpr uint32_t kCoarseDistance = 8190 * 256;

template <class Mesh>
void set_fine_pair(const Mesh& a, uint32_t of_a, const Mesh& b, uint32_t of_b, const Frame& frame,
                   uint32_t distance, uint32_t within, FinePair& pair);

/// Whether all their points, before they were rounded, are farther apart than `distance`, in 1/256
/// cell; false also where rounding leaves it open, or from kCoarseDistance on.
bool is_apart(const FinePair& pair, uint32_t distance);

/// From A's nearest point to B's, with 13 bits; zero if they intersect, or are
/// too far apart.
PackedVector direction_between(const FinePair& pair);

/// Whether corners are within a distance, of any length.
bool has_near_corners(const FinePair& pair, uint32_t distance);

}  // namespace flashbvh::detail

#endif
