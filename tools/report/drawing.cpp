// The painter's algorithm: Newell, Newell and Sancha, "A solution to the hidden surface problem",
// 1972, by the triangles' middles alone. Many triangles become fewer by vertex clustering:
// Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993.
#include "report/drawing.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "mesh/defects.hpp"
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
constexpr std::int64_t kColumn = 40;     ///< units; faces of a look follow each other by columns
constexpr std::size_t kMostSeen = 1900;  ///< faces of a drawing
constexpr std::int64_t kFar = std::int64_t{1} << 40;  ///< cells, beyond any coordinate

std::string rgb(const Colour& colour, std::int64_t shade) {
  const auto part = [&](std::size_t i) {
    return colour.dark[i] + (colour.light[i] - colour.dark[i]) * shade / (kShades - 1);
  };
  return concat("rgb(", part(0), ",", part(1), ",", part(2), ")");
}

/// The faces with corners that share a cube of `cell` cells moved to their mean. Faces that lose a
/// corner go, marks stay.
Faces merged(Faces faces, std::int64_t cell) {
  struct Sum {
    Vector of{};
    std::int64_t count = 0;
  };
  std::map<std::tuple<Paint, std::int64_t, std::int64_t, std::int64_t>, Sum> sums;
  const auto sum_at = [&](Paint paint, const LatticePoint& corner) -> Sum& {
    const auto cube = [&](std::size_t axis) { return (corner[axis] + kFar) / cell; };
    return sums[{paint, cube(0), cube(1), cube(2)}];
  };
  for (const Face& face : faces) {
    for (const LatticePoint& corner : face.corner) {
      auto& [of, count] = sum_at(face.paint, corner);
      of = {of[0] + corner[0], of[1] + corner[1], of[2] + corner[2]};
      ++count;
    }
  }
  Faces kept;
  std::set<std::pair<Paint, std::array<LatticePoint, 3>>> known;
  for (Face& face : faces) {
    for (LatticePoint& corner : face.corner) {
      const auto& [of, count] = sum_at(face.paint, corner);
      corner = {of[0] / count, of[1] / count, of[2] / count};
    }
    const auto& [p, q, r] = face.corner;
    const bool is_kept = face.paint >= kIntersected || (p != q && q != r && r != p);
    if (is_kept && known.emplace(face.paint, face.corner).second) {
      kept.push_back(face);
    }
  }
  return kept;
}

/// How bright a face looks, 0 to kShades - 1: Lambert's law under one lamp, above and to the left
/// of the viewer. Both sides look alike.
std::int64_t shade_of(const Face& face, const View& view) {
  const Vector u = difference(face.corner[1], face.corner[0]);
  const Vector v = difference(face.corner[2], face.corner[0]);
  Vector normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  while (std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])}) >= 1 << 20) {
    normal = {normal[0] / 2, normal[1] / 2, normal[2] / 2};
  }
  const std::int64_t length = square_root(dot(normal, normal));
  if (length == 0 || face.paint >= kIntersected) {
    return 0;
  }
  const std::int64_t side = dot(normal, view.towards) < 0 ? -1 : 1;
  // The lamp in the picture's directions, a thousand long.
  const std::int64_t lit =
      -384 * dot(normal, view.right) + 512 * dot(normal, view.up) + 768 * dot(normal, view.towards);
  return std::clamp<std::int64_t>(side * lit * kShades / (1000 * View::kUnit * length), 0,
                                  kShades - 1);
}

/// Layers behind all others.
constexpr std::size_t kMarks = SIZE_MAX - 1;
constexpr std::size_t kHidden = SIZE_MAX;

/// A face in the drawing.
struct Flat {
  std::array<Vector, 3> corner;  ///< clockwise, as seen
  std::int64_t depth;
  std::size_t layer;  ///< from 0, the furthest
  Paint paint;
  std::int64_t shade;

  std::int64_t look() const { return paint * kShades + shade; }  ///< the number of its class
};

std::int64_t side_of(const Vector& p, const Vector& q, const Vector& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

bool contains(const Flat& face, const Vector& point) {
  const auto& [p, q, r] = face.corner;
  return side_of(p, q, point) > 0 && side_of(q, r, point) > 0 && side_of(r, p, point) > 0;
}

/// Whether a line along an edge of `t` has `u` on its other side.
bool separates(const Flat& t, const Flat& u) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector& from = t.corner[i];
    const Vector& to = t.corner[(i + 1) % 3];
    if (std::all_of(u.corner.begin(), u.corner.end(),
                    [&](const Vector& corner) { return side_of(from, to, corner) <= 0; })) {
      return true;
    }
  }
  return false;
}

/// The faces in the drawing, but for hidden backs.
std::vector<Flat> flattened(const Faces& faces, const Frame& frame) {
  std::vector<Flat> all;
  for (const Face& face : faces) {
    Flat flat = {{frame.project(face.corner[0]), frame.project(face.corner[1]),
                  frame.project(face.corner[2])},
                 0,
                 0,
                 face.paint,
                 shade_of(face, frame.view)};
    auto& [p, q, r] = flat.corner;
    const std::int64_t area = side_of(p, q, r);  // y is downwards: of a front below 0
    if (face.is_solid && area >= 0 && face.paint < kIntersected) {
      continue;
    }
    flat.depth = p[2] + q[2] + r[2];
    if (area < 0) {
      std::swap(q, r);
    }
    all.push_back(flat);
  }
  return all;
}

/// How often a face lies in front of the middle of a mark.
std::ptrdiff_t covers_of_marks(const std::vector<Flat>& faces) {
  std::ptrdiff_t covers = 0;
  for (const Flat& mark : faces) {
    const auto& [p, q, r] = mark.corner;
    const Vector middle = {(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3, 0};
    const auto hides = [&](const Flat& face) {
      return face.paint < kIntersected && face.depth < mark.depth && contains(face, middle);
    };
    if (mark.paint >= kIntersected) {
      covers += std::count_if(faces.begin(), faces.end(), hides);
    }
  }
  return covers;
}

/// Puts each face in a layer of its own or of faces that do not hide it, and marks in front; leaves
/// out what a single face covers.
void set_layers(std::vector<Flat>& faces) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Flat& t, const Flat& u) { return t.depth > u.depth; });
  for (auto face = faces.begin(); face != faces.end(); ++face) {
    if (face->paint >= kIntersected) {
      face->layer = kMarks;
      continue;
    }
    for (auto below = faces.begin(); below != face; ++below) {
      if (below->layer >= kMarks || separates(*face, *below) || separates(*below, *face)) {
        continue;
      }
      if (std::all_of(below->corner.begin(), below->corner.end(),
                      [&](const Vector& corner) { return contains(*face, corner); })) {
        below->layer = kHidden;
      } else {
        face->layer = std::max(face->layer, below->layer + (below->look() == face->look() ? 0 : 1));
      }
    }
  }
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                             [](const Flat& face) { return face.layer == kHidden; }),
              faces.end());
}

/// A path for all faces of a layer that look alike.
std::string paths(std::vector<Flat> faces) {
  set_layers(faces);
  const auto order = [](const Flat& flat) {
    return std::tuple(flat.layer, flat.look(), flat.corner[0][0] / kColumn, flat.corner);
  };
  std::sort(faces.begin(), faces.end(),
            [&](const Flat& t, const Flat& u) { return order(t) < order(u); });
  std::string svg = "<g class=\"faces\">";
  const Flat* last = nullptr;
  for (const Flat& face : faces) {
    const auto& [p, q, r] = face.corner;
    Vector from = {0, 0, 0};
    if (last == nullptr || last->layer != face.layer || last->look() != face.look()) {
      svg += concat((last == nullptr ? "" : "\"/>"), "<path class=\"f", face.look(), "\" d=\"");
    } else {
      from = last->corner[0];
    }
    last = &face;
    svg += "m" + step(from, p) + "l" + step(p, q) + (r[0] < q[0] ? "" : " ") + step(q, r) + "z";
  }
  return svg + (last == nullptr ? "" : "\"/>") + "</g>\n";
}

}  // namespace

std::string paint_style() {
  std::string style;
  for (std::int64_t paint = 0; paint < kPaintCount; ++paint) {
    const Colour& colour = kPaintColours[static_cast<std::size_t>(paint)];
    const bool is_mark = paint >= kIntersected;
    style += concat(".paint", paint, "{background:", rgb(colour, kShades - 1), "}\n");
    for (std::int64_t shade = 0; shade < (is_mark ? 1 : kShades); ++shade) {
      const std::string look = rgb(colour, shade);
      style += concat(".faces .f", paint * kShades + shade, "{fill:", look, ";stroke:", look,
                      (paint > kIntersected ? ";stroke-width:2px}\n"
                       : is_mark            ? ";fill-opacity:.65}\n"
                                            : "}\n"));
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

Frame frame_of_marks(const Faces& faces) {
  const std::vector<LatticePoint> points = points_of(faces);
  View view = views()[0];
  Frame best(view, points);
  std::ptrdiff_t fewest = PTRDIFF_MAX;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Frame frame(view, points);
    const std::ptrdiff_t covers = covers_of_marks(flattened(faces, frame));
    if (covers < fewest) {
      fewest = covers;
      best = frame;
    }
    for (Vector* const v : {&view.right, &view.up, &view.towards}) {
      *v = {-(*v)[1], (*v)[0], (*v)[2]};
    }
  }
  return best;
}

std::string drawing(Faces faces, const Frame& frame) {
  std::vector<Flat> seen = flattened(faces, frame);
  for (std::int64_t cell = frame.across / 400 + 1; seen.size() > kMostSeen;
       cell += seen.size() > 4 * kMostSeen ? cell : cell / 4 + 1) {
    faces = merged(std::move(faces), cell);
    seen = flattened(faces, frame);
  }
  return paths(std::move(seen));
}

std::string circle(const Faces& faces, const Frame& frame) {
  LatticePoint low = {INT64_MAX, INT64_MAX, 0};
  LatticePoint high = {INT64_MIN, INT64_MIN, 0};
  for (const LatticePoint& corner : marked_corners(faces)) {
    const Vector at = frame.project(corner);
    low = {std::min(low[0], at[0]), std::min(low[1], at[1]), 0};
    high = {std::max(high[0], at[0]), std::max(high[1], at[1]), 0};
  }
  if (low[0] > high[0] || high[0] - low[0] + high[1] - low[1] > kDrawingSide * 2 / 3) {
    return "";
  }
  const Vector size = difference(high, low);
  return concat("<circle cx=", (low[0] + high[0]) / 2, " cy=", (low[1] + high[1]) / 2,
                " r=", square_root(dot(size, size)) / 2 + 20, "></circle>\n");
}

}  // namespace flashbvh::tool
