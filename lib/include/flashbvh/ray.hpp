// Rays: what a segment hits of a mesh, and how often it goes through a closed one.
//
// A ray has an end here: a segment between two points of the lattice, as a sensor has a reach. It
// is exact and watertight: whether a triangle is hit, and in which order, is decided in integers;
// no ray is lost between triangles that share an edge or a corner.
//
// Two questions, two rules. A *hit* is closed: touching a triangle counts, its edges and corners
// too, each triangle by itself, so a ray through a shared edge hits both; one that lies in a
// triangle's plane hits it where it first has a point of it. A *crossing* of a closed surface is
// counted after the segment is moved by less than any number, always to the same side: through a
// shared edge or corner it is one if the surface is gone through, and none, or one out and one in,
// if it is grazed.
//
// Points are cells of the mesh's frame, as it was drawn, within kMaxRayCoordinate of the mesh's
// origin; float.hpp makes them of lengths. One call answers one question; a ray through a mesh
// of a thousand triangles visits some 30 boxes, and 100 at worst (lib/docs/figures.md, Rays).
#ifndef FLASHBVH_RAY_HPP
#define FLASHBVH_RAY_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/segment_walk.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// What a ray hits. How far along the segment: above / below of it, exactly, from 0 to 1.
template <class Index>
struct RayHit {
  Index triangle;  ///< its id
  Index slot;      ///< in the mesh's array: what a later ray begins with
  /// Which side the ray meets: 1 the front, where corners turn counter-clockwise; -1 the back; 0
  /// where it lies in the triangle's plane, or the triangle has no area.
  int8_t side;
  SegmentShare along;
};

/// No triangle to begin with.
template <class Index>
constexpr Index kNoHint = static_cast<Index>(-1);

/// After an error `yes` is true, and nothing else holds: what cannot be decided may be hit.
template <class Index>
struct [[nodiscard]] RayAnswer {
  /// `done`; `ray_out_of_range`: an end lies too far off; `hint_invalid`.
  Status status;
  bool yes;
  RayHit<Index> hit;
  uint32_t visits;  ///< boxes tested
};

/// The first hit along the segment; of several in one place that of the least triangle id. `hint`:
/// the slot of a triangle that may be near it, as the ray before has hit, which spares visits;
/// the hit never depends on it. Stack: 704 bytes on Cortex-M3 to M55 at -O2.
template <class Index>
RayAnswer<Index> nearest_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                             const Segment& segment, Index hint = kNoHint<Index>) noexcept;

/// Any hit, the first that the walk comes to: whether something is in the way.
template <class Index>
RayAnswer<Index> any_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                         const Segment& segment) noexcept;

/// Hands each hit to `visit(hit)`, in the tree's order, until it returns false. `done` at the end,
/// `full` if `visit` said no more, `ray_out_of_range`.
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

/// A number of crossings; 0 after an error.
struct [[nodiscard]] CrossingCount {
  Status status;  ///< `done`, `not_closed`, `ray_out_of_range`
  int32_t outwards;
  uint32_t visits;  ///< boxes tested
};

/// How often the segment goes out of a closed mesh, less how often it goes in: the winding number
/// of its start less that of its end, both moved by less than any number.
template <class Index>
CrossingCount signed_crossings(const BasicMesh<Index, Layout::post_indexed>& mesh,
                               const Segment& segment) noexcept;

/// Where a hit is, in the mesh's frame: each coordinate within 1/256 cell of the exact one.
[[nodiscard]] FinePoint point_along(const Segment& segment, const SegmentShare& along) noexcept;

/// How far that is from the segment's start, in 1/256 cell: within 2/256 of the exact one.
[[nodiscard]] uint32_t distance_along(const Segment& segment, const SegmentShare& along) noexcept;

}  // namespace flashbvh

#endif
