// Solids: whether a point lies inside a closed mesh, and whether two bodies have a point in common.
//
// A closed surface (Mesh::is_closed: each edge is run through as often one way as the other) goes
// round a point a whole number of times, its winding number. That is the number of its triangles
// above the point, each counted by the side that it turns to it. The point is moved by less than
// any number to the side of edges and corners that are right above it, always to the same one, so
// that no crossing is lost or counted twice: exact, no retry. Inside is where the number is not 0,
// so a mesh that is inside out has the same inside, and what two shells both enclose is inside.
//
// Source: Edelsbrunner and Muecke, "Simulation of Simplicity", ACM Transactions on Graphics 9(1),
// 1990.
#ifndef FLASHBVH_SOLID_HPP
#define FLASHBVH_SOLID_HPP

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// Where a point is.
enum class PointSide : uint8_t {
  outside = 0,
  on_surface = 1,
  inside = 2,
};

/// After an error `side` is `inside`, what cannot be decided may be inside: where inside is the
/// good answer, as of a place in a room, look at the status, too.
struct [[nodiscard]] PointAnswer {
  Status status;  ///< `done`, or `not_closed`
  PointSide side;
  uint32_t visits;  ///< boxes tested
};

/// Where `point` is, in the mesh's frame as it was drawn, in cells: within +-2^29 and its origin.
/// `not_closed`: the mesh has no inside.
///
/// Visits the boxes above and below the point along z, some tens. Stack: 384 bytes on Cortex-M3 to
/// M55 at -O2.
template <class Index>
PointAnswer inside(const BasicMesh<Index, Layout::post_indexed>& mesh, const Point& point) noexcept;

/// Whether a shell of A or B, which lies at `pose` in A's frame, has its first vertex inside the
/// other: of bodies whose triangles don't intersect, whether one is in the other, wholly or by a
/// shell. With a PairQuery that ended `done` without a pair this is solids_intersect() in slices.
/// Both are closed: else `not_closed`; `cell_mismatch` and the pose's errors as of a query; `yes`
/// after any error. `yes` always means that they have a point in common.
///
/// Visits some tens of boxes a shell, as inside(); it is not cut into slices. Stack: 704 bytes.
template <class Index>
Answer one_is_inside(const BasicMesh<Index, Layout::post_indexed>& a,
                     const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) noexcept;

/// Whether A and B, which lies at `pose` in A's frame, have any point in common, surfaces and
/// insides: triangles that intersect, or a shell of one of them inside the other. Both are closed:
/// else `not_closed`, and `yes` as after any error. Stack: 752 bytes.
template <class Index>
Answer solids_intersect(const BasicMesh<Index, Layout::post_indexed>& a,
                        const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) noexcept;

}  // namespace flashbvh

#endif
