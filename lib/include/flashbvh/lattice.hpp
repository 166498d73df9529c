// The lattice: the integer coordinates in which all collision geometry lives.
//
// A mesh is rounded once, on the desktop, to multiples of its cell (a length). All boxes, vertices
// and answers are then integers, which makes answers equal on every core.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/plain/points.h"

namespace flashbvh {

/// Largest magnitude of a baked coordinate, in cells: 15-bit coordinates in 16-bit fields.
///
/// The spare bit lets the sum of two box bounds fit 16 bits, so packed arithmetic neither wraps nor
/// saturates (detail/bounds/box.hpp). It also keeps rotated meshes in 16 bits (16,383 * sqrt(3)
/// = 28,377).
constexpr int32_t kMaxCoordinate = 16383;

using Vertex = flashbvh_vertex;
using Point = flashbvh_point;
/// Inside the library, coordinates are relative to A's origin.
using Triangle = flashbvh_triangle;

/// fine_length_rounded_up() (float.hpp) converts a length in the mesh's unit to it.
using FineLength = flashbvh_fine_length;
/// float.hpp converts it to the mesh's unit.
using FinePoint = flashbvh_fine_point;
/// Units of a FinePoint in a cell.
constexpr int32_t kFineOne = 256;

using Segment = flashbvh_segment;
/// Largest distance of a segment's ends from the mesh's origin along each axis, in cells: 32 times
/// a vertex's. Determinants then stay below 2^57.
constexpr int32_t kMaxRayCoordinate = (1 << 19) - 1;
/// A fraction of a segment: above / below, from 0 to 1. `below` is positive; both are below 2^53.
struct SegmentShare {
  int64_t above;
  int64_t below;
};
/// Returns -1, 0 or 1 if the point at `x` is before, at or behind the point at `y`. Exact.
int order_along(const SegmentShare& x, const SegmentShare& y) noexcept;

/// A closed box: all points with lower <= coordinate <= upper, in cells.
struct Box {
  Vertex lower;
  Vertex upper;
};

/// A box as stored in flash: 12 bytes, low half first. Each half is a bound or a negated bound,
/// plus kMaxCoordinate + 1: 1 to 32,767.
struct PackedBox {
  uint32_t upper_xy;  ///< upper x, upper y
  uint32_t lower_xy;  ///< negated lower x, negated lower y
  uint32_t z;         ///< upper z, negated lower z
};

namespace detail {

/// Offset that makes a bound (or a negated one) a positive number of 15 bits.
constexpr int32_t kBoundBias = kMaxCoordinate + 1;

static_assert(2 * (kMaxCoordinate + kBoundBias) <= 0xFFFF, "sums of two bounds fit 16 bits");

constexpr uint32_t pack_bound(int32_t bound) {
  return static_cast<uint32_t>(bound + kBoundBias);
}
constexpr int16_t unpack_bound(uint32_t half) {
  return static_cast<int16_t>(static_cast<int32_t>(half) - kBoundBias);
}
constexpr int16_t unpack_negated(uint32_t half) {
  return static_cast<int16_t>(kBoundBias - static_cast<int32_t>(half));
}

}  // namespace detail

/// Packs a box of vertices into a node's format.
constexpr PackedBox pack(const Box& box) {
  using detail::join_halves;
  using detail::pack_bound;
  return {join_halves(pack_bound(box.upper.x), pack_bound(box.upper.y)),
          join_halves(pack_bound(-box.lower.x), pack_bound(-box.lower.y)),
          join_halves(pack_bound(box.upper.z), pack_bound(-box.lower.z))};
}

/// Unpacks a node's box, in cells from the mesh's origin.
constexpr Box unpack(const PackedBox& box) {
  using namespace detail;
  return {{unpack_negated(low_half(box.lower_xy)), unpack_negated(high_half(box.lower_xy)),
           unpack_negated(high_half(box.z))},
          {unpack_bound(low_half(box.upper_xy)), unpack_bound(high_half(box.upper_xy)),
           unpack_bound(low_half(box.z))}};
}

static_assert(sizeof(Vertex) == 6, "vertices are packed three halfwords");

}  // namespace flashbvh
