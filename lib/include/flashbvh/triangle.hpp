// Two triangles: the common part of a pair that intersects, and the nearest points of any pair.
//
// Queries decide exactly that a pair intersects (detail/predicates/triangle.hpp). These functions
// compute where, for drawing, measuring or pushing bodies apart, one pair in each call; no query
// pays for them. Query::last_pair() and transform_pair() return a pair's triangles.
#pragma once

#include <stdint.h>

#include "flashbvh/lattice.hpp"

namespace flashbvh {

/// Largest difference along each axis between two corners of one triangle, in cells. Meshes keep
/// within it under any pose: 2 * 16,383 * sqrt(3) = 56,753, and a cell for rounding.
constexpr int32_t kMaxContactSpan = 57000;
/// Largest difference along each axis between any two corners of two triangles, in cells.
/// Transformed vertices keep within it.
constexpr int32_t kMaxContactDistance = 160000;
/// Largest magnitude of a corner's coordinate, in cells: an origin's, plus a mesh's extent.
constexpr int32_t kMaxContactCoordinate = (1 << 29) + kMaxContactDistance / 2;

using Normal = flashbvh_normal;
using Contact = flashbvh_contact;

/// Kinds of the common part of two triangles.
enum class ContactKind : uint8_t {
  segment = FLASHBVH_CONTACT_SEGMENT,
  coplanar = FLASHBVH_CONTACT_COPLANAR,
  degenerate = FLASHBVH_CONTACT_DEGENERATE,
};

/// Returns the common part of `a` and `b`, which intersect.
///
/// The order of corners and of arguments changes only the normals, as their definition says.
/// Translating both triangles by whole cells translates the ends equally. Each triangle spans at
/// most kMaxContactSpan along each axis, both together at most kMaxContactDistance. Coordinates are
/// within +-kMaxContactCoordinate. This is not checked; every pair that a query reports complies.
/// For triangles that do not intersect, the ends are meaningless and the normals correct.
///
/// Cost in instructions on a Cortex-M4 at -O2: 1,800 for two planes that cross, 5,000 on average
/// and at most 8,500 for coplanar triangles (tests/predicates/contact_cost_test.cpp prints them).
/// Stack: 280 bytes on Cortex-M3 to M55 at -O2, without the contact's own 104 bytes.
///
/// Source: the common line as in Guigue and Devillers (detail/predicates/triangle.hpp).
[[nodiscard]] Contact contact_of(const Triangle& a, const Triangle& b) noexcept;

/// 1 in the fixed point of a UnitVector.
constexpr int32_t kUnitOne = 1 << 30;
using UnitVector = flashbvh_unit_vector;
using NearestPoints = flashbvh_nearest_points;

/// Returns the nearest points of two triangles in A's frame, such as those of Query::last_pair()
/// and transform_pair(). Differences of their corners must be below 2^17 cells along each axis. If
/// the triangles intersect, both points are one common point.
[[nodiscard]] NearestPoints nearest_points_of(const Triangle& a, const Triangle& b) noexcept;

/// A squared distance, exactly: above / below square cells. Each has 128 bits, the high word first;
/// `below` is positive.
struct SquaredDistance {
  uint64_t above[2];
  uint64_t below[2];
};
/// Returns the squared distance of two triangles, as for nearest_points_of(); 0 if they intersect.
[[nodiscard]] SquaredDistance squared_distance(const Triangle& a, const Triangle& b) noexcept;

}  // namespace flashbvh
