#include "report/simplified_section.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/arm_pictures.hpp"
#include "report/html.hpp"
#include "simplify/deviation.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using simplify::Point;
using simplify::PointTriangle;

/// More edges are too many to see.
constexpr std::size_t kMostEdges = 6000;
/// Half of a close-up's side: so many times the deviation.
constexpr double kAround = 12;
/// A close-up's triangles are cut until they are such a part of its side.
constexpr double kSmall = 1.0 / 8;

PointTriangle corners_of(const bake::SourceMesh& mesh, const bake::TriangleCorners& corners) {
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

LatticePoint cells_of(const Point& p, double cell) {
  return {std::llround(p[0] / cell), std::llround(p[1] / cell), std::llround(p[2] / cell)};
}

Face face_of(const PointTriangle& triangle, double cell) {
  return {{cells_of(triangle[0], cell), cells_of(triangle[1], cell), cells_of(triangle[2], cell)},
          kFirstMesh};
}

/// A cube, of which a close-up shows what lies in it.
struct Cube {
  Point centre;
  double half;

  bool has(const Point& p) const {
    return std::fabs(p[0] - centre[0]) <= half && std::fabs(p[1] - centre[1]) <= half &&
           std::fabs(p[2] - centre[2]) <= half;
  }
  bool may_have(const PointTriangle& triangle) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
      if (low > centre[axis] + half || high < centre[axis] - half) {
        return false;
      }
    }
    return true;
  }
  std::vector<LatticePoint> corners(double cell) const {
    std::vector<LatticePoint> points;
    for (unsigned i = 0; i < 8; ++i) {
      points.push_back(cells_of(
          {centre[0] + ((i & 1) != 0 ? half : -half), centre[1] + ((i & 2) != 0 ? half : -half),
           centre[2] + ((i & 4) != 0 ? half : -half)},
          cell));
    }
    return points;
  }
};

void add_inside(const PointTriangle& triangle, const Cube& cube, double cell, Faces& faces) {
  if (!cube.may_have(triangle)) {
    return;
  }
  const Point centre = simplify::centre_of(triangle);
  if (simplify::radius_of(triangle, centre) > 2 * kSmall * cube.half) {
    for (const PointTriangle& part : simplify::quarters_of(triangle)) {
      add_inside(part, cube, cell, faces);
    }
  } else if (cube.has(centre)) {
    faces.push_back(face_of(triangle, cell));
  }
}

/// The edges of triangles that face the viewer, each once.
std::set<std::array<std::uint32_t, 2>> seen_edges(const bake::SourceMesh& mesh) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    const PointTriangle at = corners_of(mesh, corners);
    const Point normal =
        simplify::cross(simplify::minus(at[1], at[0]), simplify::minus(at[2], at[0]));
    if (normal[0] - normal[1] + normal[2] < 0) {
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      edges.insert({low, high});
    }
  }
  return edges;
}

/// What of the edge lies in the cube; empty where nothing does.
std::vector<Point> inside(const Point& from, const Point& to, const Cube& cube) {
  double begin = 0;
  double end = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = to[axis] - from[axis];
    const double low = cube.centre[axis] - cube.half - from[axis];
    const double high = cube.centre[axis] + cube.half - from[axis];
    if (step == 0) {
      if (low > 0 || high < 0) {
        return {};
      }
      continue;
    }
    begin = std::max(begin, std::min(low / step, high / step));
    end = std::min(end, std::max(low / step, high / step));
  }
  const auto at = [&](double part) {
    return Point{from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]),
                 from[2] + part * (to[2] - from[2])};
  };
  return begin < end ? std::vector<Point>{at(begin), at(end)} : std::vector<Point>();
}

/// Edges as lines; of `cube` alone, or all.
std::string wires(const bake::SourceMesh& mesh, const Frame& frame, double cell, const Cube* cube) {
  const std::set<std::array<std::uint32_t, 2>> edges = seen_edges(mesh);
  if (cube == nullptr && edges.size() > kMostEdges) {
    return "";
  }
  std::string path;
  for (const auto& [a, b] : edges) {
    std::vector<Point> ends = {mesh.vertices[a], mesh.vertices[b]};
    if (cube != nullptr) {
      ends = inside(ends[0], ends[1], *cube);
    }
    if (!ends.empty()) {
      const Vector from = frame.project(cells_of(ends[0], cell));
      const Vector to = frame.project(cells_of(ends[1], cell));
      path += concat("M", from[0], " ", from[1], "L", to[0], " ", to[1]);
    }
  }
  return "<path class=wire d=\"" + path + "\"/>\n";
}

std::string pictures(const CoarseMesh& mesh, const simplify::Deviation& deviation,
                     const Measure& measure) {
  const double cell = measure.cell;
  Faces faces;
  for (const bake::TriangleCorners& corners : mesh.original.triangles) {
    faces.push_back(face_of(corners_of(mesh.original, corners), cell));
  }
  const Frame whole(points_of(faces));
  const LatticePoint where = cells_of(deviation.where, cell);
  const Cube cube = {deviation.where, kAround * std::max(deviation.most, cell)};
  const Frame near(cube.corners(cell));
  Faces inside;
  for (const bake::TriangleCorners& corners : mesh.original.triangles) {
    add_inside(corners_of(mesh.original, corners), cube, cell, inside);
  }
  const std::string label = escaped(mesh.name) + ", the file&#39;s mesh and the baked one";
  return "<div class=views>\n" +
         figure(faces, whole, measure, label,
                wires(mesh.coarse, whole, cell, nullptr) +
                    outline(where, whole.across / 24 + 1, whole),
                "Faces: the file&#39;s mesh; lines: what is baked; ring: the largest deviation") +
         figure(inside, near, measure, label + ", from near",
                wires(mesh.coarse, near, cell, &cube) +
                    outline(where, std::llround(deviation.most / cell), near),
                "The ring from near, as large as the deviation") +
         "</div>\n";
}

std::string mesh_part(const CoarseMesh& mesh, const Measure& measure) {
  const simplify::Deviation deviation = simplify::deviation_between(
      mesh.original, mesh.coarse, 2 * std::max(mesh.deviation, measure.cell));
  std::string where;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    where += (axis == 0 ? "at " : ", ") + significant(deviation.where[axis], 4);
  }
  return "<h3>" + escaped(mesh.name) + "</h3>\n" +
         facts(fact("triangles", grouped(mesh.original.triangles.size()) + " &rarr; " +
                                     grouped(mesh.coarse.triangles.size())) +
               fact("largest deviation", length_of(measure, mesh.deviation),
                    where + measure.suffix + "; either mesh from the other, proven")) +
         pictures(mesh, deviation, measure);
}

std::string lengths_table(const CoarseMeshes& all) {
  if (all.lengths.empty()) {
    return "";
  }
  Cells columns = {"--simplify", "#triangles"};
  for (const std::uint32_t leaf_size : all.leaf_sizes) {
    columns.push_back(concat("#bytes, --leaf-size ", leaf_size));
  }
  std::vector<Cells> rows;
  for (const simplify::LengthRow& row : all.lengths) {
    Cells cells = {row.length == 0 ? "as it is" : shortest(row.length) + all.measure.suffix,
                   grouped(row.triangles)};
    for (const double bytes : row.bytes) {
      cells.push_back(std::isfinite(bytes) ? grouped(static_cast<std::uint64_t>(bytes))
                                           : "too large");
    }
    rows.push_back(std::move(cells));
  }
  return table("What a length costs: flash of all together", columns, rows);
}

}  // namespace

std::string simplified_section(const CoarseMeshes& all) {
  std::string html = lengths_table(all);
  for (const CoarseMesh& mesh : all.meshes) {
    html += mesh_part(mesh, all.measure);
  }
  return section("simplified", "What was simplified", html);
}

std::string simplified_page(const CoarseMeshes& all) {
  const std::string title = all.meshes.size() == 1 ? escaped(all.meshes[0].name)
                                                   : counted(all.meshes.size(), "mesh", "meshes");
  return page(title, "bake", "what is baked of a mesh", simplified_section(all) + footer());
}

}  // namespace flashbvh::tool
