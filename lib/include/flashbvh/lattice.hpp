// The lattice: the integer coordinates in which all collision geometry lives.
//
// A mesh is rounded once, on the desktop, to multiples of its cell (a length). From then on every
// box, vertex and answer is integer arithmetic, which is what makes answers equal on every core.
#ifndef FLASHBVH_LATTICE_HPP
#define FLASHBVH_LATTICE_HPP

#include <stdint.h>

#include "flashbvh/plain/points.h"

namespace flashbvh {

/// Largest magnitude of a baked coordinate, in cells: 15-bit coordinates in 16-bit fields.
///
/// The spare bit lets the sum of two box bounds stay in 16 bits, so that packed arithmetic neither
/// wraps nor saturates (detail/bounds/box.hpp), and lets a rotated mesh stay inside 16 bits
/// (16,383 * sqrt(3) = 28,377).
constexpr int32_t kMaxCoordinate = 16383;

using Vertex = flashbvh_vertex;
using Point = flashbvh_point;
/// Inside the library: from A's origin on.
using Triangle = flashbvh_triangle;

/// float.hpp turns it into the mesh's unit.
using FinePoint = flashbvh_fine_point;
/// Steps of a FinePoint in a cell.
constexpr int32_t kFineOne = 256;

using Segment = flashbvh_segment;
/// Largest distance of a segment's ends from the mesh's origin along each axis, in cells: 32 times
/// that of a vertex. Determinants stay below 2^57.
constexpr int32_t kMaxRayCoordinate = (1 << 19) - 1;
/// A share of a segment: above / below, from 0 to 1; `below` is positive. Both are below 2^53.
struct SegmentShare {
  int64_t above;
  int64_t below;
};

static_assert(sizeof(Vertex) == 6, "vertices are packed three halfwords");

}  // namespace flashbvh

#endif
