// B's lattice under a pose that turns it, seen from A's: where each vertex of B goes, and what the
// box test needs (box_rotated.hpp).
//
// A vertex p goes to floor(R p + o + 1/2), where R is the pose's rotation with 22 fraction bits and
// o, with 14 of them, takes both meshes' origins in. That is a function of p alone, so a placed
// mesh keeps its edges and corners together. Each coordinate is within 1/2 + 1/100 cell of what the
// pose's own numbers give (lib/docs/design.md, Rotation).
//
// R is kept in two parts, so that all arithmetic has 16-bit factors and 32-bit sums, which every
// core has: 14 fraction bits for the boxes, 8 more for the vertices.
#ifndef FLASHBVH_ROTATED_PLACEMENT_HPP
#define FLASHBVH_ROTATED_PLACEMENT_HPP

#include <stdint.h>

#include "flashbvh/box_packed.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/packed_multiply.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// Fraction bits of the boxes' rotation, of offsets and of placed centres.
constexpr unsigned kPlacementBits = 14;
constexpr int32_t kPlacementOne = 1 << kPlacementBits;

/// Offsets are kept within +-this, in cells. Beyond 16,383 * (1 + sqrt(3)) + 1 cells no vertex of B
/// can be anywhere near A, and a larger offset says nothing else; this one leaves every sum of the
/// box test in 32 bits.
constexpr int32_t kMaxOffset = 48000;

/// A 3x3 matrix of signed 16-bit numbers, two in a word. 20 bytes.
struct PackedMatrix {
  uint32_t xy[3];  ///< of each row: first column low, second high
  uint32_t z01;    ///< third column: row 0 low, row 1 high
  uint32_t z2;     ///< third column: row 2 low; 0 high
};

/// 52 bytes; trivial, so that it can share memory with what a translation needs.
struct RotatedPlacement {
  PackedMatrix rotation;  ///< kPlacementOne is 1
  int8_t rest[3][3];      ///< what the rotation lacks, in 2^-22
  int32_t offset[3];      ///< kPlacementOne is one cell
  int32_t box_margin;     ///< of placed bounds, kPlacementOne is one cell; see box_rotated.hpp
  int32_t axis_margin;    ///< of B's axes, 4,096 is one cell; see box_rotated.hpp

  /// Sets all members. The origins are the trees', within +-2^29 cells; `root_b` contains all that
  /// will be placed. False, and only the offset is set, if two meshes with these root boxes are so
  /// far apart that they cannot meet; true where in doubt. A bad pose gives a bad placement.
  bool prepare(const Pose& pose, const int32_t (&origin_a)[3], const PackedBox& root_a,
               const int32_t (&origin_b)[3], const PackedBox& root_b);

  /// In cells from A's origin: within +-80,000.
  Point place(const Vertex& v) const;

 private:
  void set_offset(const Pose& pose, const int32_t (&origin_a)[3], const int32_t (&origin_b)[3]);
  void set_rotation(const Pose& pose, int32_t reach_b);
  bool far_apart(const PackedBox& root_a, int32_t reach_b) const;
};

}  // namespace flashbvh

#endif
