// The painter's algorithm by the triangles' middles alone. Many triangles become fewer by vertex
// clustering: Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex
// scenes", 1993.
#include "report/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "mesh/defects.hpp"
#include "mesh/units.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct Colour {
  int dark[3];   ///< red, green, blue where no light falls
  int light[3];  ///< where all of it does
};

constexpr std::array<Colour, kPaintCount> kPaintColours = {{
    {{62, 76, 98}, {196, 210, 230}},   // blue grey
    {{104, 82, 46}, {232, 211, 170}},  // sand
    {{96, 96, 96}, {178, 178, 178}},   // grey
    {{225, 40, 40}, {225, 40, 40}},    // red
    {{255, 60, 210}, {255, 60, 210}},  // magenta
    {{255, 150, 40}, {255, 150, 40}},  // orange
    {{225, 29, 72}, {225, 29, 72}},    // crimson
    {{124, 58, 237}, {124, 58, 237}},  // violet
    {{5, 150, 105}, {5, 150, 105}},    // green
}};

constexpr std::int64_t kShades = 9;
constexpr std::size_t kMostSeen = 1900;               ///< faces of a picture
constexpr std::int64_t kFar = std::int64_t{1} << 40;  ///< cells, beyond any coordinate
constexpr std::int64_t kStrip = 120;                  ///< height of the axes and the scale

bool is_mark(const Face& face) {
  return face.paint >= kIntersected;
}

std::string rgb(const Colour& colour, std::int64_t shade) {
  const auto part = [&](std::size_t i) {
    return colour.dark[i] + (colour.light[i] - colour.dark[i]) * shade / (kShades - 1);
  };
  return concat("rgb(", part(0), ",", part(1), ",", part(2), ")");
}

/// The faces with corners that share a cube of `cell` cells moved to their mean. Faces that lose a
/// corner go, marks stay.
Faces merged(Faces faces, std::int64_t cell) {
  std::map<std::tuple<Paint, Vector>, std::pair<Vector, std::int64_t>> sums;
  const auto sum_at = [&](Paint paint, const LatticePoint& at) -> std::pair<Vector, std::int64_t>& {
    return sums[{paint, {(at[0] + kFar) / cell, (at[1] + kFar) / cell, (at[2] + kFar) / cell}}];
  };
  for (const Face& face : faces) {
    for (const LatticePoint& corner : face.corner) {
      auto& [sum, count] = sum_at(face.paint, corner);
      sum = {sum[0] + corner[0], sum[1] + corner[1], sum[2] + corner[2]};
      ++count;
    }
  }
  Faces kept;
  std::set<std::pair<Paint, std::array<LatticePoint, 3>>> known;
  for (Face& face : faces) {
    for (LatticePoint& corner : face.corner) {
      const auto& [sum, count] = sum_at(face.paint, corner);
      corner = {sum[0] / count, sum[1] / count, sum[2] / count};
    }
    const auto& [p, q, r] = face.corner;
    if ((is_mark(face) || (p != q && q != r && r != p)) &&
        known.emplace(face.paint, face.corner).second) {
      kept.push_back(face);
    }
  }
  return kept;
}

/// How bright a face looks, 0 to kShades - 1: Lambert's law under one lamp, above and to the left
/// of the viewer. Both sides look alike.
std::int64_t shade_of(const Face& face) {
  const Vector u = difference(face.corner[1], face.corner[0]);
  const Vector v = difference(face.corner[2], face.corner[0]);
  Vector normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  while (std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])}) >= 1 << 20) {
    normal = {normal[0] / 2, normal[1] / 2, normal[2] / 2};
  }
  const std::int64_t length = square_root(dot(normal, normal));
  if (length == 0 || is_mark(face)) {
    return 0;
  }
  const std::int64_t side = dot(normal, Frame::kTowards) < 0 ? -1 : 1;
  // The lamp in the picture's directions, a thousand long.
  const std::int64_t lit = -384 * dot(normal, Frame::kRight) + 512 * dot(normal, Frame::kUp) +
                           768 * dot(normal, Frame::kTowards);
  return std::clamp<std::int64_t>(side * lit * kShades / (1000 * Frame::kUnit * length), 0,
                                  kShades - 1);
}

/// A face in the picture.
struct Flat {
  std::int64_t nearness;  ///< the greater, the later it is drawn; marks are in front
  std::array<Vector, 3> corner;
  std::int64_t look;  ///< the number of its class
};

/// The faces in the picture, but for hidden backs.
std::vector<Flat> flattened(const Faces& faces, const Frame& frame) {
  std::vector<Flat> seen;
  for (const Face& face : faces) {
    const Vector p = frame.project(face.corner[0]);
    const Vector q = frame.project(face.corner[1]);
    const Vector r = frame.project(face.corner[2]);
    // y is downwards: the area of a front is below 0.
    const std::int64_t area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if (!face.is_solid || area < 0 || is_mark(face)) {
      seen.push_back({is_mark(face) ? INT64_MAX : -(p[2] + q[2] + r[2]),
                      {p, q, r},
                      face.paint * kShades + shade_of(face)});
    }
  }
  return seen;
}

/// A relative step of an SVG path: "12-3", as a minus sign separates, too.
std::string step(const Vector& from, const Vector& to) {
  return concat(to[0] - from[0], (to[1] < from[1] ? "" : " "), to[1] - from[1]);
}

std::string drawing(Faces faces, const Frame& frame) {
  std::vector<Flat> seen = flattened(faces, frame);
  for (std::int64_t cell = frame.across / 400 + 1; seen.size() > kMostSeen;
       cell += seen.size() > 4 * kMostSeen ? cell : cell / 4 + 1) {
    faces = merged(std::move(faces), cell);
    seen = flattened(faces, frame);
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Flat& t, const Flat& u) { return t.nearness < u.nearness; });
  std::string svg = "<g class=\"faces\">";
  for (const auto& [nearness, corner, look] : seen) {
    svg += concat("<path class=\"f", look, "\" d=\"m", step({}, corner[0]), "l",
                  step(corner[0], corner[1]), corner[2][0] < corner[1][0] ? "" : " ",
                  step(corner[1], corner[2]), "z\"/>");
  }
  return svg + "</g>\n";
}

/// The axes as arrows.
std::string axes() {
  constexpr std::int64_t x = 80;
  constexpr std::int64_t y = Frame::kSide + 60;
  constexpr std::int64_t arrow = 55;
  std::string svg;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t to_x = Frame::kRight[axis] * arrow / Frame::kUnit;
    const std::int64_t to_y = -Frame::kUp[axis] * arrow / Frame::kUnit;
    svg += concat("<path class=axis d=\"M", x, " ", y, "l", to_x, " ", to_y,
                  "\"/><text x=", x + to_x * 135 / 100, " y=", y + to_y * 135 / 100, ">",
                  std::string(1, "xyz"[axis]), "</text>\n");
  }
  return svg;
}

/// The longest of 1, 2 or 5 times a power of ten that takes at most a third of the side.
double scale_length(double across) {
  const double most = across / 3;
  const double power = std::pow(10, std::floor(std::log10(most)));
  return power * (most < 2 * power ? 1 : most < 5 * power ? 2 : 5);
}

std::string scale_bar(const Frame& frame, const Measure& measure) {
  const double across = static_cast<double>(frame.across) * measure.cell;
  const double length = scale_length(across);
  const auto units = static_cast<std::int64_t>(std::llround(Frame::kSide * length / across));
  const std::int64_t right = Frame::kSide - 40;
  const std::int64_t y = Frame::kSide + 80;
  return concat("<path class=axis d=\"M", right - units, " ", y - 14, "v28m0-14h", units,
                "m0-14v28\"/><text x=", right - units / 2, " y=", y - 38, ">",
                length_of(measure, length), "</text>\n");
}

}  // namespace

Vector difference(const Vector& u, const Vector& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;  // below 2^31
  for (std::int64_t bit = std::int64_t{1} << 30; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) {
      root += bit;
    }
  }
  return root;
}

std::string paint_style() {
  std::string style;
  for (std::int64_t paint = 0; paint < kPaintCount; ++paint) {
    const Colour& colour = kPaintColours[static_cast<std::size_t>(paint)];
    style += concat(".paint", paint, "{background:", rgb(colour, kShades - 1), "}\n");
    for (std::int64_t shade = 0; shade < (paint >= kIntersected ? 1 : kShades); ++shade) {
      const std::string look = rgb(colour, shade);
      style += concat(".faces .f", paint * kShades + shade, "{fill:", look, ";stroke:", look,
                      paint > kIntersected ? ";stroke-width:2px}\n" : "}\n");
    }
  }
  return style;
}

std::string class_of(Paint paint) {
  return concat("paint", static_cast<int>(paint));
}

bool is_solid(const bake::LatticeMesh& mesh) {
  return edge_defects(mesh.triangles, {}).none() && !is_inside_out(mesh, {});
}

std::vector<LatticePoint> points_of(const Faces& faces) {
  std::vector<LatticePoint> points;
  for (const Face& face : faces) {
    points.insert(points.end(), face.corner.begin(), face.corner.end());
  }
  return points;
}

std::vector<LatticePoint> marked_corners(const Faces& faces) {
  Faces marked;
  std::copy_if(faces.begin(), faces.end(), std::back_inserter(marked),
               [](const Face& face) { return face.paint == kIntersected; });
  return points_of(marked);
}

Frame::Frame(const std::vector<LatticePoint>& points) {
  const std::array<Vector, 3> directions = {kRight, kUp, kTowards};
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t low = INT64_MAX;
    std::int64_t high = INT64_MIN;
    for (const LatticePoint& point : points) {
      const std::int64_t along = dot(directions[i], point);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    middle[i] = low + (high - low) / 2;
    if (i < 2) {
      across = std::max(across, (high - low) * 33 / 32 / kUnit + 1);  // a margin for lines
    }
  }
}

Vector Frame::project(const LatticePoint& point) const {
  const auto along = [&](const Vector& direction, std::size_t i) {
    return (dot(direction, point) - middle[i]) * kSide / (across * kUnit);
  };
  return {kSide / 2 + along(kRight, 0), kSide / 2 - along(kUp, 1), -along(kTowards, 2)};
}

std::string circle(const Faces& faces, const Frame& frame) {
  Vector low = {INT64_MAX, INT64_MAX, 0};
  Vector high = {INT64_MIN, INT64_MIN, 0};
  for (const LatticePoint& corner : marked_corners(faces)) {
    const Vector at = frame.project(corner);
    low = {std::min(low[0], at[0]), std::min(low[1], at[1]), 0};
    high = {std::max(high[0], at[0]), std::max(high[1], at[1]), 0};
  }
  if (low[0] > high[0] || high[0] - low[0] + high[1] - low[1] > Frame::kSide * 2 / 3) {
    return "";
  }
  const Vector size = difference(high, low);
  return concat("<circle cx=", (low[0] + high[0]) / 2, " cy=", (low[1] + high[1]) / 2,
                " r=", square_root(dot(size, size)) / 2 + 20, "></circle>\n");
}

std::string outline(const LatticePoint& centre, std::int64_t radius, const Frame& frame) {
  const Vector at = frame.project(centre);
  return concat("<circle cx=", at[0], " cy=", at[1], " r=", radius * Frame::kSide / frame.across,
                "></circle>\n");
}

Measure measure_of(const ImageFile& image) {
  const std::string unit = unit_name(image.unit());
  return {image.cell(), unit.empty() ? "" : " " + unit};
}

std::string length_of(const Measure& measure, double length) {
  const double size = std::fabs(length);
  return (size >= 1e4 && size < 1e9 ? fixed(length, 0) : significant(length, 4)) + measure.suffix;
}

std::string figure(const Faces& faces, const Frame& frame, const Measure& measure,
                   const std::string& label, const std::string& overlay,
                   const std::string& caption) {
  return concat("<figure><svg viewBox=\"0 0 ", Frame::kSide, " ", Frame::kSide + kStrip,
                "\" role=img aria-label=\"", label, "\">\n", drawing(faces, frame), overlay, axes(),
                scale_bar(frame, measure), "</svg><figcaption>", caption,
                "</figcaption></figure>\n");
}

}  // namespace flashbvh::tool
