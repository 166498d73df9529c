// Lambert's cosine law under one lamp, above and to the left of who looks.
#include "report/shade.hpp"

#include <algorithm>

#include "report/square_root.hpp"

namespace flashbvh::report {
namespace {

/// At right angles to the triangle, of components below 2^20; 0 for a triangle without area.
Vector normal_of(const std::array<Vertex, 3>& triangle) {
  const auto difference = [&](std::size_t corner) -> Vector {
    return {triangle[corner].x - triangle[0].x, triangle[corner].y - triangle[0].y,
            triangle[corner].z - triangle[0].z};
  };
  const Vector u = difference(1);
  const Vector v = difference(2);
  Vector normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const auto largest = [&] {
    return std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
  };
  while (largest() >= 1 << 20) {
    for (std::int64_t& part : normal) {
      part /= 2;
    }
  }
  return normal;
}

}  // namespace

std::uint32_t shade_of(const std::array<Vertex, 3>& triangle, const View& view,
                       std::uint32_t shades) {
  const Vector normal = normal_of(triangle);
  const std::int64_t length = square_root(dot(normal, normal));
  if (length == 0) {
    return 0;
  }
  const std::int64_t side = dot(normal, view.towards) < 0 ? -1 : 1;
  // The lamp in the picture's directions, a thousand long.
  const std::int64_t lit =
      -384 * dot(normal, view.right) + 512 * dot(normal, view.up) + 768 * dot(normal, view.towards);
  const std::int64_t most = 1000 * View::kUnit * length;
  return static_cast<std::uint32_t>(
      std::clamp<std::int64_t>(side * lit * shades / most, 0, shades - 1));
}

}  // namespace flashbvh::report
