// Segments against triangles, in exact 64-bit integers.
//
// Source for the perturbation: Edelsbrunner and Muecke, "Simulation of Simplicity", ACM
// Transactions on Graphics 9(1), 1990.
#include "segment_hit.hpp"

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"

namespace flashbvh::detail {
namespace {

bool is_zero(const WideVector& v) {
  return (v.x | v.y | v.z) == 0;
}

int first_sign(const WideVector& v) {
  return v.x != 0 ? sign_of(v.x) : v.y != 0 ? sign_of(v.y) : sign_of(v.z);
}

/// The sign gives the side of the line on which the edge from u to v passes. Returns six times the
/// volume of `way`, u and v relative to `from`; below 2^57.
int64_t turn(const Point& from, const Vector& way, const Point& u, const Point& v) {
  return dot(cross<WideVector>(difference(u, from), difference(v, u)), way);
}

/// Returns whether a line meets a triangle that is not parallel to it.
bool meets(const Triangle& t, const Point& from, const Vector& way, bool along_normal) {
  for (unsigned i = 0; i < 3; ++i) {
    const int64_t side = turn(from, way, t.corner[i], t.corner[next(i)]);
    if (along_normal ? side < 0 : side > 0) {
      return false;
    }
  }
  return true;
}

/// Sets `share` to above / below, with any signs; returns whether it is from 0 to 1.
bool get_share(int64_t above, int64_t below, SegmentShare& share) {
  share = below < 0 ? SegmentShare{-above, -below} : SegmentShare{above, below};
  return share.above >= 0 && share.above <= share.below;
}

/// get_share() of part / whole for parallel vectors, of which `whole` is not zero.
bool get_ratio(const WideVector& part, const WideVector& whole, SegmentShare& share) {
  return whole.x != 0   ? get_share(part.x, whole.x, share)
         : whole.y != 0 ? get_share(part.y, whole.y, share)
                        : get_share(part.z, whole.z, share);
}

WideVector widened(const Vector& v) {
  return {v.x, v.y, v.z};
}

/// Sets the share at which the segment meets the edge from u to v, or u if the edge is along it.
bool get_share_of_edge(const Point& from, const Vector& way, const Point& u, const Point& v,
                       SegmentShare& share) {
  const Vector edge = difference(v, u);
  const Vector to_edge = difference(u, from);
  const WideVector both = cross<WideVector>(way, edge);
  const WideVector aside = cross<WideVector>(to_edge, way);
  if (is_zero(both)) {
    return is_zero(aside) && get_ratio(widened(to_edge), widened(way), share);
  }
  SegmentShare of_edge;
  return dot(both, to_edge) == 0 && get_ratio(aside, both, of_edge) &&
         get_ratio(cross<WideVector>(to_edge, edge), both, share);
}

// The parts of this rare case are not inlined, so that their stack frames do not add up.

[[gnu::noinline]] bool has_segment_point(const Triangle& t, const Point& from, const Point& to) {
  return triangles_intersect(t, {{from, to, to}});
}

/// Sets the first share at which the segment meets an edge of the triangle; else 1, its end.
[[gnu::noinline]] void get_first_of_edges(const Segment& segment, const Triangle& t,
                                          SegmentShare& first) {
  first = {1, 1};
  const Vector way = difference(segment.to, segment.from);
  for (unsigned i = 0; i < 3; ++i) {
    SegmentShare share;
    if (get_share_of_edge(segment.from, way, t.corner[i], t.corner[detail::next(i)], share) &&
        order_along(share, first) < 0) {
      first = share;
    }
  }
}

/// Sets the first share at which a segment in the triangle's plane, or a segment and a triangle
/// without area, meet: 0 or on an edge. Returns whether they meet.
[[gnu::noinline]] bool meet_in_plane(const Segment& segment, const Triangle& t,
                                     SegmentShare& along) {
  if (!has_segment_point(t, segment.from, segment.to)) {
    return false;
  }
  if (has_segment_point(t, segment.from, segment.from)) {
    along = {0, 1};
  } else {
    get_first_of_edges(segment, t, along);
  }
  return true;
}

}  // namespace

bool first_meeting(const Segment& segment, const Triangle& t, SegmentShare& along,
                   int8_t& side) noexcept {
  const Vector way = difference(segment.to, segment.from);
  const auto normal = normal_of<WideVector>(t);
  const int64_t slope = dot(normal, way);
  const int64_t height = dot(normal, difference(t.corner[0], segment.from));
  if (slope != 0) {
    side = slope < 0 ? 1 : -1;
    return get_share(height, slope, along) && meets(t, segment.from, way, slope > 0);
  }
  side = 0;
  return height == 0 && meet_in_plane(segment, t, along);
}

int passage(const Triangle& t, const Point& from, const Vector& way) noexcept {
  int side = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const Point& u = t.corner[i];
    const Point& v = t.corner[next(i)];
    const int64_t volume = turn(from, way, u, v);
    // The volume's gradient by the line's place is way x (v - u): 0 if the edge is parallel.
    const int own =
        volume != 0 ? sign_of(volume) : first_sign(cross<WideVector>(way, difference(v, u)));
    if (own == 0 || own == -side) {
      return 0;
    }
    side = own;
  }
  return side;
}

int side_of_plane(const Triangle& t, const Point& p) noexcept {
  const auto normal = normal_of<WideVector>(t);
  const int64_t height = dot(normal, difference(p, t.corner[0]));
  return height != 0 ? sign_of(height) : first_sign(normal);
}

}  // namespace flashbvh::detail

namespace flashbvh {

int order_along(const SegmentShare& x, const SegmentShare& y) noexcept {
  using detail::full_product;
  return detail::sign_of(full_product(x.above, y.below) - full_product(y.above, x.below));
}

}  // namespace flashbvh
