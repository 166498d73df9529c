// Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988: a point lies in a
// triangle if three edge functions agree in sign; the same functions weigh the corners' depths.
// Four samples a pixel, a depth each.
#include "report/raster.hpp"

#include <algorithm>

namespace flashbvh::tool {
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

/// How bright it looks, from 0, dark, to `shades` - 1: Lambert's cosine law under one lamp, above
/// and to the left of who looks. Both sides of a triangle look alike: which one is the outside need
/// not be told right by the mesh.
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

constexpr std::int64_t kSamples = 2;  ///< a pixel's side
constexpr std::int64_t kGrid = kPictureSide * kSamples;
constexpr std::int64_t kFine = 16;  ///< steps between two samples
constexpr std::size_t kShades = 20;
constexpr std::uint32_t kLineShade = kShades / 2;  ///< seen on white and on black
constexpr std::size_t kCoverages = kSamples * kSamples;

struct Sample {
  std::int64_t depth = INT64_MAX;
  std::uint32_t shade = 0;
};

std::int64_t edge(const Projected& p, const Projected& q, std::int64_t x, std::int64_t y) {
  return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
}

/// The first and the last sample within the fine coordinates `low` to `high`.
struct Span {
  std::int64_t first;
  std::int64_t last;
};
Span span_of(std::int64_t low, std::int64_t high) {
  return {std::clamp<std::int64_t>(low / kFine, 0, kGrid - 1),
          std::clamp<std::int64_t>(high / kFine, 0, kGrid - 1)};
}

/// The square of samples that a picture is made of.
class Canvas {
 public:
  Canvas() : samples_(static_cast<std::size_t>(kGrid * kGrid)) {}

  void draw(const std::array<Projected, 3>& corner, std::uint32_t shade) {
    const std::int64_t area = edge(corner[0], corner[1], corner[2].x, corner[2].y);
    if (area == 0) {
      for (std::size_t i = 0; i < 3; ++i) {
        draw_line(corner[i], corner[(i + 1) % 3]);
      }
    } else if (area < 0) {
      fill({corner[0], corner[2], corner[1]}, -area, shade);
    } else {
      fill(corner, area, shade);
    }
  }

  Picture picture(const std::vector<Colour>& palette) const {
    Picture picture = {kPictureSide, kPictureSide, palette, {}};
    for (std::int64_t y = 0; y < kPictureSide; ++y) {
      for (std::int64_t x = 0; x < kPictureSide; ++x) {
        picture.pixels += static_cast<char>(pixel(x, y));
      }
    }
    return picture;
  }

 private:
  void put(std::int64_t x, std::int64_t y, std::int64_t depth, std::uint32_t shade) {
    Sample& sample = samples_[static_cast<std::size_t>(y * kGrid + x)];
    if (depth < sample.depth) {
      sample = {depth, shade};
    }
  }

  /// Corners in the order in which the edge functions are positive inside.
  void fill(const std::array<Projected, 3>& corner, std::int64_t area, std::uint32_t shade) {
    const auto [p, q, r] = corner;
    const Span columns = span_of(std::min({p.x, q.x, r.x}), std::max({p.x, q.x, r.x}));
    const Span rows = span_of(std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y}));
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
      const std::int64_t y = row * kFine + kFine / 2;
      for (std::int64_t column = columns.first; column <= columns.last; ++column) {
        const std::int64_t x = column * kFine + kFine / 2;
        const std::int64_t of_p = edge(q, r, x, y);
        const std::int64_t of_q = edge(r, p, x, y);
        const std::int64_t of_r = edge(p, q, x, y);
        if (of_p >= 0 && of_q >= 0 && of_r >= 0) {
          put(column, row, (of_p * p.depth + of_q * q.depth + of_r * r.depth) / area, shade);
        }
      }
    }
  }

  /// A pixel wide.
  void draw_line(const Projected& p, const Projected& q) {
    const std::int64_t steps =
        std::max({std::abs(q.x - p.x) / kFine, std::abs(q.y - p.y) / kFine, std::int64_t{1}});
    for (std::int64_t i = 0; i <= steps; ++i) {
      const std::int64_t x = p.x + (q.x - p.x) * i / steps;
      const std::int64_t y = p.y + (q.y - p.y) * i / steps;
      const Span columns = span_of(x, x + kFine);
      const Span rows = span_of(y, y + kFine);
      for (const std::int64_t row : {rows.first, rows.last}) {
        for (const std::int64_t column : {columns.first, columns.last}) {
          put(column, row, p.depth + (q.depth - p.depth) * i / steps, kLineShade);
        }
      }
    }
  }

  /// The mean of the samples that are covered, as opaque as there are many.
  std::size_t pixel(std::int64_t x, std::int64_t y) const {
    std::size_t covered = 0;
    std::size_t sum = 0;
    for (std::int64_t i = 0; i < kSamples; ++i) {
      for (std::int64_t j = 0; j < kSamples; ++j) {
        const std::int64_t row = kSamples * y + i;
        const Sample& s = samples_[static_cast<std::size_t>(row * kGrid + kSamples * x + j)];
        covered += s.depth != INT64_MAX ? 1 : 0;
        sum += s.depth != INT64_MAX ? s.shade : 0;
      }
    }
    return covered == 0 ? 0 : 1 + (covered - 1) * kShades + (sum + covered / 2) / covered;
  }

  std::vector<Sample> samples_;
};

/// Nothing; then for each number of covered samples, all shades from dark to light.
std::vector<Colour> palette() {
  std::vector<Colour> colours = {{0, 0, 0, 0}};
  for (std::size_t covered = 1; covered <= kCoverages; ++covered) {
    for (std::size_t shade = 0; shade < kShades; ++shade) {
      const auto between = [&](std::size_t dark, std::size_t light) {
        return static_cast<std::uint8_t>(dark + (light - dark) * shade / (kShades - 1));
      };
      colours.push_back({between(74, 208), between(82, 214), between(94, 222),
                         static_cast<std::uint8_t>(255 * covered / kCoverages)});
    }
  }
  return colours;
}

}  // namespace

Picture picture_of(const TriangleSoup& triangles, const View& view, const detail::Box& box) {
  constexpr std::int64_t scale = kSamples * kFine;
  const Projection projection(view, box, kPictureSide * scale, kPictureMargin * scale);
  Canvas canvas;
  for (const auto& [p, q, r] : triangles) {
    canvas.draw({projection.project(p), projection.project(q), projection.project(r)},
                shade_of({p, q, r}, view, kShades));
  }
  return canvas.picture(palette());
}

}  // namespace flashbvh::tool
