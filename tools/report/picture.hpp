// Meshes as inline SVG: flat triangles, the farthest drawn first, with axes and a scale. In
// integers: the same bytes on every machine.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

using Vector = LatticePoint;

Vector difference(const Vector& u, const Vector& v);
std::int64_t dot(const Vector& u, const Vector& v);
/// The largest number whose square is not above `value`, 0 to 2^62 - 1.
std::int64_t square_root(std::int64_t value);

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

/// CSS of the class of each paint, "paint3", in pictures and in keys.
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

/// A parallel projection from a corner, of points in the middle of a square picture. The three
/// directions are at right angles, each kUnit long.
struct Frame {
  static constexpr std::int64_t kSide = 1000;  ///< of the picture, in its units
  static constexpr std::int64_t kUnit = 1024;
  // 1,024 times 1 / sqrt(2), 1 / sqrt(6), 2 / sqrt(6) and 1 / sqrt(3).
  static constexpr Vector kRight = {724, 724, 0};
  static constexpr Vector kUp = {-418, 418, 836};
  static constexpr Vector kTowards = {591, -591, 591};  ///< from the mesh to the viewer

  /// Precondition: `points` is not empty.
  explicit Frame(const std::vector<LatticePoint>& points);

  /// To the right, downwards and away from the viewer, in units of the picture.
  Vector project(const LatticePoint& point) const;

  Vector middle{};          ///< along the three directions
  std::int64_t across = 1;  ///< cells along the picture's side
};

/// A circle round the faces that intersect; nothing where it would hold most of the picture.
std::string circle(const Faces& faces, const Frame& frame);

/// Of a ball, its radius in cells.
std::string outline(const LatticePoint& centre, std::int64_t radius, const Frame& frame);

/// A cell, in a unit, and the text behind lengths in it: " mm"; empty where the unit is unknown.
struct Measure {
  double cell;
  std::string suffix;
};
Measure measure_of(const ImageFile& image);
/// A length, given in the measure's unit, to four digits, with the unit.
std::string length_of(const Measure& measure, double length);

/// The picture as HTML. `label` is read aloud; `overlay`: SVG in units of the picture. All three
/// texts are HTML. Corners of many faces are merged until at most 1,900 are seen.
std::string figure(const Faces& faces, const Frame& frame, const Measure& measure,
                   const std::string& label, const std::string& overlay,
                   const std::string& caption);

}  // namespace flashbvh::tool
