// Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988: a point lies in a
// triangle if three edge functions agree in sign; the same functions weigh the corners' depths.
// Four samples a pixel, a depth each: meshes that intersect hide each other as they should.
#include "report/raster.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct Colour {
  std::int64_t dark[3];   ///< red, green, blue where no light falls
  std::int64_t light[3];  ///< where all of it does
};

constexpr std::array<Colour, kPaintCount> kPaintColours = {{
    {{62, 76, 98}, {196, 210, 230}},   // blue grey
    {{104, 82, 46}, {232, 211, 170}},  // sand
    {{96, 96, 96}, {178, 178, 178}},   // grey
    {{150, 12, 20}, {255, 84, 66}},    // red
    {{190, 0, 150}, {255, 60, 210}},   // magenta
    {{150, 70, 0}, {255, 150, 40}},    // orange
    {{225, 29, 72}, {225, 29, 72}},    // crimson
    {{124, 58, 237}, {124, 58, 237}},  // violet
    {{5, 150, 105}, {5, 150, 105}},    // green
}};

constexpr std::int64_t kShades = 20;

/// At right angles to the triangle, of components below 2^20; 0 for a triangle without area.
Vector normal_of(const std::array<LatticePoint, 3>& triangle) {
  const auto difference = [&](std::size_t corner) -> Vector {
    return {triangle[corner][0] - triangle[0][0], triangle[corner][1] - triangle[0][1],
            triangle[corner][2] - triangle[0][2]};
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

/// How bright it looks, from 0, dark, to kShades - 1: Lambert's cosine law under one lamp, above
/// and to the left of who looks. Both sides of a triangle look alike: which one is the outside need
/// not be told right by the mesh.
std::uint32_t shade_of(const std::array<LatticePoint, 3>& triangle, const View& view) {
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
      std::clamp<std::int64_t>(side * lit * kShades / most, 0, kShades - 1));
}

constexpr std::int64_t kSamples = 2;    ///< a pixel's side
constexpr std::int64_t kEdgeWidth = 3;  ///< of a face seen from the edge, in samples
constexpr std::int64_t kMarkWidth = 5;  ///< of a line, likewise
constexpr std::int64_t kFine = 16;      ///< steps between two samples

struct Sample {
  std::int64_t depth = INT64_MAX;
  std::uint32_t shade = 0;
  Paint paint = kFirstMesh;
};

std::int64_t edge(const Projected& p, const Projected& q, std::int64_t x, std::int64_t y) {
  return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
}

struct Span {
  std::int64_t first;
  std::int64_t last;
};

/// The square of samples that a picture is made of.
class Canvas {
 public:
  explicit Canvas(std::int64_t side)
      : side_(side), grid_(side * kSamples), samples_(static_cast<std::size_t>(grid_ * grid_)) {}

  void draw_face(std::array<Projected, 3> corner, std::uint32_t shade, Paint paint) {
    if (paint >= kIntersected) {
      for (Projected& place : corner) {
        place.depth -= 4 * View::kUnit;  // two cells
      }
    }
    const std::int64_t area = edge(corner[0], corner[1], corner[2].x, corner[2].y);
    const Sample face = {0, shade, paint};
    if (area == 0) {
      for (std::size_t i = 0; i < 3; ++i) {
        draw_line(corner[i], corner[(i + 1) % 3], kEdgeWidth, face);
      }
    } else if (area < 0) {
      fill({corner[0], corner[2], corner[1]}, -area, face);
    } else {
      fill(corner, area, face);
    }
  }

  /// So many samples wide.
  void draw_line(const Projected& p, const Projected& q, std::int64_t width, const Sample& line) {
    const std::int64_t steps =
        std::max({std::abs(q.x - p.x) / kFine, std::abs(q.y - p.y) / kFine, std::int64_t{1}});
    for (std::int64_t i = 0; i <= steps; ++i) {
      const std::int64_t x = p.x + (q.x - p.x) * i / steps;
      const std::int64_t y = p.y + (q.y - p.y) * i / steps;
      const std::int64_t reach = (width - 1) * kFine / 2;
      const Span columns = span_of(x - reach, x + reach);
      const Span rows = span_of(y - reach, y + reach);
      for (std::int64_t row = rows.first; row <= rows.last; ++row) {
        for (std::int64_t column = columns.first; column <= columns.last; ++column) {
          put(column, row, p.depth + (q.depth - p.depth) * i / steps, line);
        }
      }
    }
  }

  Drawn drawn() const {
    Drawn drawn = {{static_cast<std::uint32_t>(side_), {}}, {}};
    drawn.picture.pixels.reserve(static_cast<std::size_t>(4 * side_ * side_));
    for (std::int64_t y = 0; y < side_; ++y) {
      for (std::int64_t x = 0; x < side_; ++x) {
        append_pixel(drawn, x, y);
      }
    }
    return drawn;
  }

 private:
  /// The first and the last sample within the fine coordinates `low` to `high`.
  Span span_of(std::int64_t low, std::int64_t high) const {
    return {std::clamp<std::int64_t>(low / kFine, 0, grid_ - 1),
            std::clamp<std::int64_t>(high / kFine, 0, grid_ - 1)};
  }

  void put(std::int64_t x, std::int64_t y, std::int64_t depth, const Sample& what) {
    Sample& sample = samples_[static_cast<std::size_t>(y * grid_ + x)];
    if (depth < sample.depth) {
      sample = {depth, what.shade, what.paint};
    }
  }

  /// Corners in the order in which the edge functions are positive inside.
  void fill(const std::array<Projected, 3>& corner, std::int64_t area, const Sample& face) {
    const auto [p, q, r] = corner;
    const Span columns = span_of(std::min({p.x, q.x, r.x}), std::max({p.x, q.x, r.x}));
    const Span rows = span_of(std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y}));
    const std::int64_t x = columns.first * kFine + kFine / 2;
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
      const std::int64_t y = row * kFine + kFine / 2;
      std::int64_t of_p = edge(q, r, x, y);
      std::int64_t of_q = edge(r, p, x, y);
      std::int64_t of_r = edge(p, q, x, y);
      for (std::int64_t column = columns.first; column <= columns.last; ++column) {
        if (of_p >= 0 && of_q >= 0 && of_r >= 0) {
          put(column, row, (of_p * p.depth + of_q * q.depth + of_r * r.depth) / area, face);
        }
        of_p -= (r.y - q.y) * kFine;
        of_q -= (p.y - r.y) * kFine;
        of_r -= (q.y - p.y) * kFine;
      }
    }
  }

  /// The mean of the samples that are covered, as opaque as there are many.
  void append_pixel(Drawn& drawn, std::int64_t x, std::int64_t y) const {
    std::string& pixels = drawn.picture.pixels;
    std::int64_t covered = 0;
    std::int64_t sum[3] = {};
    for (std::int64_t i = 0; i < kSamples * kSamples; ++i) {
      const std::int64_t row = kSamples * y + i / kSamples;
      const Sample& sample =
          samples_[static_cast<std::size_t>(row * grid_ + kSamples * x + i % kSamples)];
      if (sample.depth == INT64_MAX) {
        continue;
      }
      ++covered;
      ++drawn.seen[sample.paint];
      const auto& [dark, light] = kPaintColours[sample.paint];
      for (std::size_t part = 0; part < 3; ++part) {
        sum[part] += dark[part] + (light[part] - dark[part]) * sample.shade / (kShades - 1);
      }
    }
    if (covered == 0) {
      pixels.append(4, '\0');
      return;
    }
    for (const std::int64_t part : sum) {
      pixels += static_cast<char>(part / covered);
    }
    pixels += static_cast<char>(255 * covered / (kSamples * kSamples));
  }

  std::int64_t side_;
  std::int64_t grid_;
  std::vector<Sample> samples_;
};

}  // namespace

std::string paint_style() {
  std::string style;
  for (std::size_t paint = 0; paint < kPaintCount; ++paint) {
    const auto& [red, green, blue] = kPaintColours[paint].light;
    style += concat(".paint", paint, "{background:rgb(", red, ",", green, ",", blue, ")}\n");
  }
  return style;
}

std::string class_of(Paint paint) {
  return concat("paint", static_cast<int>(paint));
}

Drawn draw(const Scene& scene, const View& view, const Frame& frame, std::int64_t side) {
  const Projection projection(view, frame, side * kSamples * kFine);
  Canvas canvas(side);
  for (const auto& [corner, paint] : scene.faces) {
    const auto& [p, q, r] = corner;
    canvas.draw_face({projection.project(p), projection.project(q), projection.project(r)},
                     shade_of(corner, view), paint);
  }
  for (const auto& [end, paint] : scene.lines) {
    Projected from = projection.project(end[0]);
    Projected to = projection.project(end[1]);
    from.depth = to.depth = INT64_MIN;
    canvas.draw_line(from, to, kMarkWidth, {0, kShades - 1, paint});
  }
  return canvas.drawn();
}

}  // namespace flashbvh::tool
