// Rays: the triangles of a mesh that a segment hits, and its crossings of a closed mesh.
//
// A ray is a segment between two lattice points, as a sensor's range is limited. Rays are exact and
// watertight: integers decide which triangles are hit and in which order; no ray slips between
// triangles that share an edge or a corner.
//
// Hits and crossings have different rules. A *hit* includes a triangle's edges and corners, for
// each triangle separately, so a ray through a shared edge hits both triangles. A ray in a
// triangle's plane hits it at the ray's first point in the triangle. *Crossings* of a closed
// surface are counted after an infinitesimal move of the segment, always to one side. At a shared
// edge or corner, a ray through the surface counts one crossing; a grazing ray none, or one out and
// one in.
//
// Points are in cells of the mesh's source frame, within kMaxRayCoordinate of the mesh's origin;
// float.hpp converts lengths. Each call answers one query. A ray through a mesh of a thousand
// triangles visits about 30 boxes, and 100 at worst (lib/docs/figures.md, Rays).
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/segment_walk.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// A ray's hit. `along`: its fraction of the segment, exact, from 0 to 1.
template <class Index>
struct RayHit {
  Index triangle;  ///< its id
  Index slot;      ///< slot in the mesh's array: a hint for the next ray
  /// The side that the ray meets: 1 the front, where corners turn counter-clockwise; -1 the back; 0
  /// if the ray lies in the triangle's plane, or the triangle has no area.
  int8_t side;
  SegmentShare along;
};

/// The hint without a triangle.
template <class Index>
constexpr Index kNoHint = static_cast<Index>(-1);

/// A ray's result. After an error `yes` is true and no other field is valid: the ray may hit.
template <class Index>
struct [[nodiscard]] RayAnswer {
  /// `done`; `ray_out_of_range`: an end is too far away; `hint_invalid`.
  Status status;
  bool yes;
  RayHit<Index> hit;
  uint32_t visits;  ///< boxes tested
};

/// Returns the first hit along the segment; of several at one point, the least triangle id. `hint`:
/// the slot of a triangle that may be near it, such as the last ray's hit, which saves visits. The
/// hit never depends on the hint. Stack: 704 bytes on Cortex-M3 to M55 at -O2.
template <class Index>
RayAnswer<Index> nearest_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                             const Segment& segment, Index hint = kNoHint<Index>) noexcept;

/// Returns any hit, the first that the walk finds: tests for an obstacle.
template <class Index>
RayAnswer<Index> any_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                         const Segment& segment) noexcept;

/// Passes each hit to `visit(hit)`, in the tree's order, until it returns false. `done` at the end,
/// `full` if `visit` returned false, `ray_out_of_range`.
template <class Index, class Visitor>
Status for_each_hit(const BasicMesh<Index, Layout::post_indexed>& mesh, const Segment& segment,
                    Visitor&& visit) {
  detail::SegmentWalk<BasicMesh<Index, Layout::post_indexed>> walk(mesh, segment);
  RayHit<Index> hit;
  while (walk.next(hit)) {
    if (!visit(static_cast<const RayHit<Index>&>(hit))) {
      return Status::full;
    }
  }
  return walk.status();
}

/// A signed number of crossings; 0 after an error.
struct [[nodiscard]] CrossingCount {
  Status status;  ///< `done`, `not_closed`, `ray_out_of_range`
  int32_t outwards;
  uint32_t visits;  ///< boxes tested
};

/// Returns how often the segment leaves a closed mesh, minus how often it enters. This is the
/// winding number of its start minus that of its end, both moved infinitesimally.
template <class Index>
CrossingCount signed_crossings(const BasicMesh<Index, Layout::post_indexed>& mesh,
                               const Segment& segment) noexcept;

/// Returns a hit's point in the mesh's frame: each coordinate within 1/256 cell of the exact one.
[[nodiscard]] FinePoint point_along(const Segment& segment, const SegmentShare& along) noexcept;

/// Returns the hit's distance from the segment's start in 1/256 cell; the error is at most 2/256.
[[nodiscard]] uint32_t distance_along(const Segment& segment, const SegmentShare& along) noexcept;

}  // namespace flashbvh
