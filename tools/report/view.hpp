// From where a mesh is looked at. All in integers: the same picture on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_VIEW_HPP
#define FLASHBVH_TOOLS_REPORT_VIEW_HPP

#include <array>
#include <cstdint>

#include "flashbvh/detail/box.hpp"

namespace flashbvh::tool {

using Vector = std::array<std::int64_t, 3>;

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

/// A parallel projection. The three directions are at right angles, each about kUnit long.
struct View {
  static constexpr std::int64_t kUnit = 1024;

  const char* name;     ///< "From above"
  const char* caption;  ///< which axis points where
  Vector right;
  Vector up;
  Vector towards;  ///< from the mesh to who looks at it
};

/// From a corner, from above, from the front and from the right.
const std::array<View, 4>& views();

/// A place on the picture: `x` to the right, `y` downwards, `depth` away from who looks.
struct Projected {
  std::int64_t x;
  std::int64_t y;
  std::int64_t depth;
};

/// Lays what lies in a box into a square picture, in the middle and as large as it goes.
class Projection {
 public:
  /// `side`: of the picture; `margin`: what stays free round the box.
  Projection(const View& view, const detail::Box& box, std::int64_t side, std::int64_t margin);

  Projected project(const Vertex& vertex) const;
  /// A direction in the picture's measure.
  Projected rotate(const Vector& direction) const;

 private:
  View view_;
  std::int64_t side_;
  std::int64_t room_;
  std::int64_t extent_;
  std::int64_t middle_x_;  ///< twice the middle of the box
  std::int64_t middle_y_;
};

}  // namespace flashbvh::tool

#endif
