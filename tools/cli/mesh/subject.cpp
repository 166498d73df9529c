#include "cli/mesh/subject.hpp"

#include <utility>

#include "image/mesh_warnings.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// `places`: indices in `sources`; the warning lists the triangles' numbers in the source mesh.
void mark_triangles(Subject& subject, const std::vector<SourceTriangle>& sources,
                    TriangleIds places, const char* colour, const char* what) {
  if (places.empty()) {
    return;
  }
  Json marks = Json::array();
  for (std::uint32_t& place : places) {
    const auto& [p, q, r] = sources[place].vertices;
    for (const std::uint32_t vertex : {p, q, q, r, r, p}) {
      marks.push_back(vertex);
    }
    place = sources[place].number;
  }
  subject.marks.push_back({colour, std::move(marks)});
  subject.warnings.push_back(triangle_list(places) + what);
}

void mark_edges(Subject& subject, const std::vector<OddEdge>& edges, EdgeDefect defect,
                const char* colour) {
  Json marks = Json::array();
  for (const auto& [vertices, found] : edges) {
    if (found == defect) {
      marks.push_back(vertices[0]);
      marks.push_back(vertices[1]);
    }
  }
  if (!marks.empty()) {
    subject.marks.push_back({colour, std::move(marks)});
  }
}

}  // namespace

Subject::Subject(const ImageFile& image) {
  const std::vector<SourceTriangle> sources = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, sources);
  const MeshDefects defects = surface_defects(mesh);
  mark_triangles(*this, sources, defects.duplicates, "--p1",
                 " with the three vertices of an earlier one");
  mark_triangles(*this, sources, degenerate_triangles(mesh), "--p4",
                 " without area: a segment or a point");
  const std::vector<OddEdge> edges = odd_edges(mesh.triangles, defects.duplicates);
  mark_edges(*this, edges, EdgeDefect::boundary, "--p0");
  mark_edges(*this, edges, EdgeDefect::non_manifold, "--p3");
  mark_edges(*this, edges, EdgeDefect::twisted, "--p2");
  Warnings of_surface;
  warn_of_surface(defects, "", of_surface);
  for (const PlacedWarning& warning : of_surface.all()) {
    warnings.push_back(warning.what);
  }
}

}  // namespace flashbvh::tool
