// A mesh as a picture: shaded triangles, the nearest in front.
#ifndef FLASHBVH_TOOLS_REPORT_RASTER_HPP
#define FLASHBVH_TOOLS_REPORT_RASTER_HPP

#include <array>
#include <vector>

#include "report/png.hpp"
#include "report/view.hpp"

namespace flashbvh::tool {

/// A mesh's triangles by their corners, in cells from the mesh's origin.
using TriangleSoup = std::vector<std::array<Vertex, 3>>;

/// Pixels of a picture's side.
constexpr std::int64_t kPictureSide = 480;
/// What stays free at its edges, for the lines of boxes.
constexpr std::int64_t kPictureMargin = 8;

/// The mesh on a transparent ground, in greys that are seen on white and on black. `box`: the
/// mesh's. Triangles seen from the edge are drawn as lines, so that nothing is invisible.
Picture picture_of(const TriangleSoup& triangles, const View& view, const detail::Box& box);

}  // namespace flashbvh::tool

#endif
