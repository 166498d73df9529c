// From where a mesh is looked at. All in integers: the same picture on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_VIEW_HPP
#define FLASHBVH_TOOLS_REPORT_VIEW_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

using Vector = LatticePoint;

std::int64_t dot(const Vector& u, const Vector& v);

/// The largest number whose square is not above `value`, 0 to 2^62 - 1.
inline std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;  // below 2^31
  for (std::int64_t bit = std::int64_t{1} << 30; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) {
      root += bit;
    }
  }
  return root;
}

/// A box along the axes, in cells.
struct Bounds {
  LatticePoint lower;
  LatticePoint upper;

  std::vector<LatticePoint> corners() const;
};

/// Precondition: not empty.
Bounds bounds_of(const std::vector<LatticePoint>& points);

/// A parallel projection. The three directions are at right angles, each about kUnit long.
struct View {
  static constexpr std::int64_t kUnit = 1024;

  const char* name;  ///< "From above"
  Vector right;
  Vector up;
  Vector towards;  ///< from the mesh to who looks at it
};

/// From a corner, from above, from the front and from the right.
const std::array<View, 4>& views();

/// From the four corners above.
const std::array<View, 4>& corner_views();

/// A place on the picture: `x` to the right, `y` downwards, `depth` away from who looks.
struct Projected {
  std::int64_t x;
  std::int64_t y;
  std::int64_t depth;
};

/// What is to be seen, and how large: pictures of one `across` have one scale.
struct Frame {
  std::vector<LatticePoint> points;  ///< the middle of what these take up is that of the picture
  std::int64_t across;               ///< cells along the picture's side
};

/// The points as large as all views allow, with room for lines. Precondition: not empty.
Frame frame_of(std::vector<LatticePoint> points, const std::array<View, 4>& views);

/// Lays a frame into a square picture.
class Projection {
 public:
  Projection(const View& view, const Frame& frame, std::int64_t side);

  Projected project(const LatticePoint& point) const;
  /// A direction in the picture's measure.
  Projected rotate(const Vector& direction) const;

 private:
  View view_;
  LatticePoint origin_;  ///< near what is seen, so that no product is out of range
  std::int64_t side_;
  std::int64_t extent_;
  std::int64_t left_;  ///< of the picture, from the origin
  std::int64_t top_;
};

}  // namespace flashbvh::tool

#endif
