// Points as a viewer sees them. In integers: the same drawing on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_VIEW_HPP
#define FLASHBVH_TOOLS_REPORT_VIEW_HPP

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

using Vector = LatticePoint;

Vector difference(const Vector& u, const Vector& v);
std::int64_t dot(const Vector& u, const Vector& v);

/// The largest number whose square is not above `value`, 0 to 2^62 - 1.
std::int64_t square_root(std::int64_t value);

/// Units of a drawing's side.
constexpr std::int64_t kDrawingSide = 1000;

/// A parallel projection. The three directions are at right angles, each kUnit long.
struct View {
  static constexpr std::int64_t kUnit = 1024;

  const char* name;  ///< "From above"
  Vector right;
  Vector up;
  Vector towards;  ///< from the mesh to the viewer
};

/// From a corner, from above, from the front and from the right.
const std::array<View, 4>& views();

/// A view of points in the middle of a square drawing.
struct Frame {
  /// Precondition: `points` is not empty.
  Frame(const View& seen_from, const std::vector<LatticePoint>& points);

  /// To the right, downwards and away from the viewer, in units of the drawing.
  Vector project(const LatticePoint& point) const;

  View view;
  Vector middle;        ///< along the three directions
  std::int64_t across;  ///< cells along the drawing's side; frames of one `across` have one scale
};

/// A relative step of a path: "12-3", as a minus sign separates, too.
std::string step(const Vector& from, const Vector& to);

}  // namespace flashbvh::tool

#endif
