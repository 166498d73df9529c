// Solids: tests if a point is inside a closed mesh, and if two bodies have a point in common.
//
// A closed surface (Mesh::is_closed: each edge is used as often in one direction as in the other)
// has an integer winding number around each point. It is the number of triangles above the point,
// each counted by the side that faces the point. The point is moved infinitesimally off edges and
// corners right above it, always to one side. So no crossing is lost or counted twice: exact,
// without retries. Inside means a winding number other than 0. Turning a mesh inside out does not
// change its inside, and points in two shells are inside.
//
// Source: Edelsbrunner and Muecke, "Simulation of Simplicity", ACM Transactions on Graphics 9(1),
// 1990.
#pragma once

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// The side of a closed surface on which a point lies.
enum class PointSide : uint8_t {
  outside = 0,
  on_surface = 1,
  inside = 2,
};

/// A point's side. After an error `side` is `inside`, since the point may be inside. If inside is
/// the safe answer, as for a point in a room, check the status too.
struct [[nodiscard]] PointAnswer {
  Status status;  ///< `done`, or `not_closed`
  PointSide side;
  uint32_t visits;  ///< boxes tested
};

/// Returns the side of `point`, in cells of the mesh's source frame.
/// `not_closed`: the mesh has no inside.
///
/// Visits the boxes above and below the point along z, some tens. Stack: 384 bytes on Cortex-M3 to
/// M55 at -O2.
template <class Index>
PointAnswer inside(const BasicMesh<Index, Layout::post_indexed>& mesh, const Point& point) noexcept;

/// True if a shell of A or B, which is at `pose` in A's frame, has its first vertex inside the
/// other mesh. For bodies whose triangles do not intersect, it decides if one is inside the other,
/// wholly or by a shell. After a PairQuery that ended `done` without a pair, this is
/// solids_intersect() in slices. `not_closed` unless both are closed; `cell_mismatch` and the
/// pose's errors as in a query; `yes` is true after any error. If `yes` is true without an error,
/// the bodies have a point in common.
///
/// Visits a few tens of boxes for each shell, as inside(), in one call. Stack: 704 bytes.
template <class Index>
Answer one_is_inside(const BasicMesh<Index, Layout::post_indexed>& a,
                     const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) noexcept;

/// True if A and B, which is at `pose` in A's frame, have any point in common, on surfaces or
/// inside. Their triangles intersect, or a shell of one is inside the other. `not_closed` if no
/// triangles intersect and a mesh is open; `yes` is true after any error. Stack: 752 bytes.
template <class Index>
Answer solids_intersect(const BasicMesh<Index, Layout::post_indexed>& a,
                        const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) noexcept;

}  // namespace flashbvh
