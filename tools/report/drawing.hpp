// Meshes as one inline SVG: flat triangles, the furthest drawn first. In integers: the same bytes
// on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_DRAWING_HPP
#define FLASHBVH_TOOLS_REPORT_DRAWING_HPP

#include <array>
#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "report/view.hpp"

namespace flashbvh::tool {

/// What a triangle or an edge is, by its colour.
enum Paint : std::uint8_t {
  kFirstMesh,
  kSecondMesh,
  kOtherMesh,
  kIntersected,  ///< from here on: marks, drawn in front of everything
  kNoArea,
  kDuplicate,
  kBoundary,
  kNonManifold,
  kTwisted,
  kPaintCount,
};

/// What the class of each paint, "paint3", looks like in drawings and in keys.
std::string paint_style();
std::string class_of(Paint paint);

/// A triangle; an edge, where two corners are the same.
struct Face {
  std::array<LatticePoint, 3> corner;
  Paint paint;
  bool is_solid = false;  ///< of a closed surface: its back is hidden
};

using Faces = std::vector<Face>;

std::vector<LatticePoint> points_of(const Faces& faces);
/// Of faces that intersect, in the order of the faces.
std::vector<LatticePoint> marked_corners(const Faces& faces);

/// Whether the surface is closed and its triangles run counter-clockwise, seen from outside.
bool is_solid(const bake::LatticeMesh& mesh);

/// The faces from the corner of four where the fewest others hide marks.
Frame frame_of_marks(const Faces& faces);

/// The faces as an SVG group. Corners of many are merged until at most 1,900 are seen.
std::string drawing(Faces faces, const Frame& frame);

/// A circle round the faces that intersect; nothing where it would hold most of the drawing.
std::string circle(const Faces& faces, const Frame& frame);

}  // namespace flashbvh::tool

#endif
