// The common part of two triangles that lie in one plane or have no area.
#pragma once

#include "flashbvh/triangle.hpp"

namespace flashbvh::detail {

/// A triangle; or, if it has no area, the segment between its outermost corners, which may be one
/// point. Of a segment corner[0] comes first; corner[1] and corner[2] both are the last corner.
struct Outline {
  const Point* corner[3];

  bool is_segment() const { return corner[1] == corner[2]; }
};

/// The outline holds pointers into `t`.
Outline outline_of(const Triangle& t, bool has_area);

/// Sets the ends of the common part of two intersecting triangles, which lie in one plane or both
/// have no area. The contact's normals are already set.
void set_flat_ends(const Triangle& a, const Triangle& b, Contact& contact);

}  // namespace flashbvh::detail
