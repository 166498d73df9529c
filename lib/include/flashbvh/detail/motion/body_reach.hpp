// Bounds on the travel of a body's points in a motion, and on the errors of their places.
#pragma once

#include <stdint.h>

#include "flashbvh/lattice.hpp"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/pose.hpp"

namespace flashbvh {

class BodyMotion;
using Move = flashbvh_move;

namespace detail {

/// Source: lib/docs/derivations.md, "Motions of two bodies".
class BodyReach {
 public:
  /// Sets the bounds for B with its root's box; the origins are the meshes'. False if any point may
  /// get farther than 2^19 cells from A's frame or by a path of 2^25, or if a coordinate of an
  /// origin is 2^18 cells or more; no bound holds then.
  bool set(const BodyMotion& motion, const PackedBox& box, const int32_t (&origin_a)[3],
           const int32_t (&origin_b)[3]);

  /// Gets B's frame at `middle`. Returns the most that B's points move from there until `half` of
  /// an interval before and after it, in 1/256 cell, rounded up.
  uint64_t around(const BodyMotion& motion, uint32_t middle, uint32_t half, Frame& frame) const;

  /// The error of a point of B in 1/256 cell, on the path and at its end.
  uint32_t path_error() const { return path_error_; }
  /// The rounding error of a vertex that a query places, in 1/256 cell.
  uint32_t rounding() const { return rounding_; }

 private:
  uint64_t moved_by(const Move& move, uint32_t part, const Frame& frame, uint64_t inside) const;

  uint32_t way_;  ///< longest path of a point, in 1/2,048 cell, if proportional to time; or 0
  uint32_t path_error_;
  uint32_t rounding_;
  int32_t centre_[3];  ///< of a ball that holds B, in 1/2,048 cell of B's frame
  uint32_t radius_;    ///< in 1/2,048 cell
};

}  // namespace detail
}  // namespace flashbvh
