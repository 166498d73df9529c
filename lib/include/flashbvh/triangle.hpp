// Two triangles: the common piece of a pair that intersects, and where a pair is nearest.
//
// That a pair intersects is decided exactly (detail/predicates/triangle.hpp); this says where, for
// those who draw it, measure it or push the bodies apart. A query never pays for it: a call is for
// one pair. Query::last_pair() and transform_pair() give a pair's triangles.
#ifndef FLASHBVH_TRIANGLE_HPP
#define FLASHBVH_TRIANGLE_HPP

#include <stdint.h>

#include "flashbvh/lattice.hpp"

namespace flashbvh {

/// Largest difference along one axis between two corners of one triangle, in cells. Meshes keep
/// within it under any pose: 2 * 16,383 * sqrt(3) = 56,753, and a cell for rounding.
constexpr int32_t kMaxContactSpan = 57000;
/// The same between any two corners of two triangles: what transformed vertices keep to.
constexpr int32_t kMaxContactDistance = 160000;
/// Largest magnitude of a corner's coordinate, in cells: that of an origin, and a mesh's extent.
constexpr int32_t kMaxContactCoordinate = (1 << 29) + kMaxContactDistance / 2;

using Normal = flashbvh_normal;
using Contact = flashbvh_contact;

/// What the common part of two triangles may be.
enum class ContactKind : uint8_t {
  segment = FLASHBVH_CONTACT_SEGMENT,
  coplanar = FLASHBVH_CONTACT_COPLANAR,
  degenerate = FLASHBVH_CONTACT_DEGENERATE,
};

/// The common part of `a` and `b`, which intersect.
///
/// The order of corners and of arguments changes the normals, as their definition says, and nothing
/// else; translating both triangles by whole cells translates the ends alike. Each triangle spans
/// at most kMaxContactSpan along each axis, both at most kMaxContactDistance, and coordinates are
/// within +-kMaxContactCoordinate, as those of every pair that a query reports are; this is not
/// checked. Of triangles within these bounds that do not intersect, the answer is two meaningless
/// points and correct normals.
///
/// Cost in instructions on a Cortex-M4 at -O2: 1,800 for two planes that cross, 5,000 on average
/// and at most 8,500 for coplanar triangles (tests/predicates/contact_cost_test.cpp prints them).
/// Stack: 280 bytes on Cortex-M3 to M55 at -O2, the contact itself, 104 bytes, not counted.
///
/// Source: the common line as in Guigue and Devillers (triangle.hpp).
[[nodiscard]] Contact contact_of(const Triangle& a, const Triangle& b) noexcept;

/// Of a UnitVector's coordinates: 1.
constexpr int32_t kUnitOne = 1 << 30;
using UnitVector = flashbvh_unit_vector;
using NearestPoints = flashbvh_nearest_points;

/// Of two triangles in A's frame, as Query::last_pair() and transform_pair() give them; differences
/// of their corners are below 2^17 cells along each axis. A point of an intersection is one that
/// both have.
[[nodiscard]] NearestPoints nearest_points_of(const Triangle& a, const Triangle& b) noexcept;

/// A squared distance, exactly: above / below square cells. Each has 128 bits, the high word first;
/// `below` is positive.
struct SquaredDistance {
  uint64_t above[2];
  uint64_t below[2];
};
/// The squared distance of two triangles, as nearest_points_of() takes them; 0 if they intersect.
[[nodiscard]] SquaredDistance squared_distance(const Triangle& a, const Triangle& b) noexcept;

/// The directions along which a query bounds the triangles of a leaf, rounded to 13 bits a
/// component.
struct LeafDirections {
  Point normal;  ///< of the plane of the leaf's first triangle
  Point across;  ///< in that plane, the normal of the triangle's longest edge
};
/// Of a leaf whose first triangle has these corners; false if the triangle has no area. For tools
/// that choose the first triangle.
[[nodiscard]] bool get_leaf_directions(const Vertex (&corners)[3],
                                       LeafDirections& directions) noexcept;

}  // namespace flashbvh

#endif
