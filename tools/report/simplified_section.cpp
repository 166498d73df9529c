#include "report/simplified_section.hpp"

#include <algorithm>
#include <cmath>

#include "bake/length.hpp"
#include "live/live_section.hpp"
#include "report/html.hpp"
#include "simplify/deviation.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using simplify::Point;
using simplify::PointTriangle;

/// The largest number of drawn triangles per mesh: the nearest to the largest deviation.
constexpr std::size_t kMostDrawn = 1500;

using PointTriangles = std::vector<PointTriangle>;

/// Triangles relative to a point, the nearest first.
PointTriangles triangles_about(const bake::SourceMesh& mesh, const Point& middle) {
  PointTriangles all;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    PointTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i] = simplify::minus(mesh.vertices[corners[i]], middle);
    }
    all.push_back(triangle);
  }
  const auto distance = [](const PointTriangle& triangle) {
    const Point centre = simplify::centre_of(triangle);
    return bake::length(centre[0], centre[1], centre[2]);
  };
  std::stable_sort(all.begin(), all.end(), [&](const PointTriangle& t, const PointTriangle& u) {
    return distance(t) < distance(u);
  });
  all.resize(std::min(all.size(), kMostDrawn));
  return all;
}

double farthest(const PointTriangles& triangles) {
  double most = 0;
  for (const PointTriangle& triangle : triangles) {
    for (const Point& corner : triangle) {
      most = std::max({most, std::fabs(corner[0]), std::fabs(corner[1]), std::fabs(corner[2])});
    }
  }
  return most;
}

std::vector<std::int16_t> halves_of(const PointTriangles& triangles, double step) {
  std::vector<std::int16_t> halves;
  for (const PointTriangle& triangle : triangles) {
    for (const Point& corner : triangle) {
      for (const double along : corner) {
        halves.push_back(static_cast<std::int16_t>(std::lround(along / step)));
      }
    }
  }
  return halves;
}

LiveDeviation live_of(const CoarseMesh& mesh, const simplify::Deviation& deviation,
                      const Measure& measure) {
  const PointTriangles original = triangles_about(mesh.original, deviation.where);
  const PointTriangles coarse = triangles_about(mesh.coarse, deviation.where);
  const double step = std::max({farthest(original), farthest(coarse), measure.cell}) / INT16_MAX;
  return {mesh.name, halves_of(original, step), halves_of(coarse, step), deviation.most / step,
          length_of(measure, mesh.deviation)};
}

std::string mesh_part(const CoarseMesh& mesh, const simplify::Deviation& deviation,
                      const Measure& measure) {
  std::string where;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    where += (axis == 0 ? "at " : ", ") + significant(deviation.where[axis], 4);
  }
  return "<h3>" + escaped(mesh.name) + "</h3>\n" +
         facts(fact("triangles", grouped(mesh.original.triangles.size()) + " &rarr; " +
                                     grouped(mesh.coarse.triangles.size())) +
               fact("largest deviation", length_of(measure, mesh.deviation),
                    where + measure.suffix + "; either mesh from the other, proven"));
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
  std::vector<LiveDeviation> live;
  for (const CoarseMesh& mesh : all.meshes) {
    const simplify::Deviation deviation = simplify::deviation_between(
        mesh.original, mesh.coarse, 2 * std::max(mesh.deviation, all.measure.cell));
    html += mesh_part(mesh, deviation, all.measure);
    live.push_back(live_of(mesh, deviation, all.measure));
  }
  return deviation_section(live) + section("simplified", "What was simplified", html);
}

std::string simplified_page(const CoarseMeshes& all) {
  const std::string title = all.meshes.size() == 1 ? escaped(all.meshes[0].name)
                                                   : counted(all.meshes.size(), "mesh", "meshes");
  return page(title, "bake", "what is baked of a mesh", simplified_section(all) + footer());
}

}  // namespace flashbvh::tool
