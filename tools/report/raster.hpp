// A scene as a picture: shaded triangles, the nearest in front.
#ifndef FLASHBVH_TOOLS_REPORT_RASTER_HPP
#define FLASHBVH_TOOLS_REPORT_RASTER_HPP

#include <array>
#include <string>
#include <vector>

#include "report/png.hpp"
#include "report/view.hpp"

namespace flashbvh::tool {

/// What a triangle or an edge is, told by its colour.
enum Paint : std::uint8_t {
  kFirstMesh,
  kSecondMesh,
  kOtherMesh,
  kIntersected,  ///< from here on: seen before all others at the same place
  kNoArea,
  kDuplicate,
  kBoundary,
  kNonManifold,
  kTwisted,
  kPaintCount,
};

/// The class of each paint, "paint3", for keys beside the text.
std::string paint_style();
/// Such a class.
std::string class_of(Paint paint);

struct Face {
  std::array<LatticePoint, 3> corner;
  Paint paint;
};

/// Drawn in front of everything.
struct Line {
  std::array<LatticePoint, 2> end;
  Paint paint;
};

struct Scene {
  std::vector<Face> faces;
  std::vector<Line> lines;
};

struct Drawn {
  Picture picture;
  std::array<std::size_t, kPaintCount> seen;  ///< samples of each paint
};

/// The scene on a transparent ground, in colours that are seen on white and on black. Faces seen
/// from the edge are drawn as lines, so that nothing is invisible.
Drawn draw(const Scene& scene, const View& view, const Frame& frame, std::int64_t side);

}  // namespace flashbvh::tool

#endif
