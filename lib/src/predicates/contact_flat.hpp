// The common part of two triangles in one plane, or without area.
#ifndef FLASHBVH_PREDICATES_CONTACT_FLAT_HPP
#define FLASHBVH_PREDICATES_CONTACT_FLAT_HPP

#include "flashbvh/triangle.hpp"

namespace flashbvh::detail {

/// A triangle, or, of one without area, the segment between its outermost corners, which may be one
/// point: then corner[0] comes first, and corner[1] and corner[2] are the same, that comes last.
struct Outline {
  const Point* corner[3];

  bool is_segment() const { return corner[1] == corner[2]; }
};

/// Points into the triangle.
Outline outline_of(const Triangle& t, bool has_area);

/// Sets the ends of the common part of two triangles that intersect, and lie in one plane or both
/// lack area. The contact's normals are set.
void set_flat_ends(const Triangle& a, const Triangle& b, Contact& contact);

}  // namespace flashbvh::detail

#endif
