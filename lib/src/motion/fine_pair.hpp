// Two triangles, placed on a finer grid than the lattice, for the distance of moving bodies.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh::detail {

/// A triangle of A and one of B. Coordinates are relative to the first corner of `a`, in 2^-bits
/// cell; B's corners are rounded.
struct FinePair {
  Triangle a;
  Triangle b;
  uint8_t bits;  ///< 4; less for large distances, and of large triangles
};

/// From this distance on, in 1/256 cell, pairs need no fine grid.
constexpr uint32_t kCoarseDistance = 8190 * 256;

/// Places slot `of_a` of A and slot `of_b` of B, with B's frame in A's. The grid is fine enough to
/// compare with `distance`, in 1/256 cell; `within` is its part that is not caused by motion.
template <class Mesh>
void set_fine_pair(const Mesh& a, uint32_t of_a, const Mesh& b, uint32_t of_b, const Frame& frame,
                   uint32_t distance, uint32_t within, FinePair& pair);

/// Returns whether the unrounded triangles are farther apart than `distance`, in 1/256 cell. False
/// also if rounding leaves it open, or from kCoarseDistance on.
bool is_apart(const FinePair& pair, uint32_t distance);

/// Direction from A's nearest point to B's, in 13 bits; zero if they intersect or are too distant.
PackedVector direction_between(const FinePair& pair);

/// Returns whether two corners are within a distance, in 1/256 cell, which may have any length.
bool has_near_corners(const FinePair& pair, uint32_t distance);

}  // namespace flashbvh::detail
