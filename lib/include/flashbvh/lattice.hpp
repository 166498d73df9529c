// The lattice: the integer coordinates in which all collision geometry lives.
//
// A mesh is rounded once, on the desktop, to multiples of its cell (a length). From then on every
// box, vertex and answer is integer arithmetic, which is what makes answers equal on every core.
#ifndef FLASHBVH_LATTICE_HPP
#define FLASHBVH_LATTICE_HPP

#include <stdint.h>

namespace flashbvh {

/// Largest magnitude of a baked coordinate, in cells: 15-bit coordinates in 16-bit fields.
///
/// The spare bit lets the sum of two box bounds stay in 16 bits, so that packed arithmetic neither
/// wraps nor saturates (detail/bounds/box.hpp), and lets a rotated mesh stay inside 16 bits
/// (16,383 * sqrt(3) = 28,377).
constexpr int32_t kMaxCoordinate = 16383;

/// A baked vertex: cells from the mesh's origin, each coordinate within +-kMaxCoordinate.
struct Vertex {
  int16_t x;
  int16_t y;
  int16_t z;
};

/// A transformed vertex: in cells, wide enough for any pose.
struct Point {
  int32_t x;
  int32_t y;
  int32_t z;
};

/// A triangle in the frame of mesh A, in cells: as the mesh was drawn, origin included, wherever
/// the library's users see one; inside it from A's origin on.
///
/// Its corners may lie on one line or in one point: rounding to the lattice does that.
struct Triangle {
  Point corner[3];
};

static_assert(sizeof(Vertex) == 6, "vertices are packed three halfwords");

}  // namespace flashbvh

#endif
