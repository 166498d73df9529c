#include "cli/mesh/subject.hpp"

#include <utility>

#include "mesh/defects.hpp"
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
  LiveMarks marks = {colour, {}};
  for (std::uint32_t& place : places) {
    const auto& [p, q, r] = sources[place].vertices;
    marks.vertices.insert(marks.vertices.end(), {p, q, q, r, r, p});
    place = sources[place].number;
  }
  subject.marks.push_back(std::move(marks));
  subject.warnings.push_back(triangle_list(places) + what);
}

void mark_edges(Subject& subject, const std::vector<OddEdge>& edges, EdgeDefect defect,
                const char* colour, const char* one, const char* many) {
  LiveMarks marks = {colour, {}};
  for (const auto& [vertices, found] : edges) {
    if (found == defect) {
      marks.vertices.insert(marks.vertices.end(), vertices.begin(), vertices.end());
    }
  }
  if (const std::size_t count = marks.vertices.size() / 2; count != 0) {
    subject.marks.push_back(std::move(marks));
    subject.warnings.push_back(concat(count, " ", count == 1 ? one : many));
  }
}

void mark_defects(const ImageFile& image, Subject& subject) {
  const std::vector<SourceTriangle> sources = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, sources);
  const TriangleIds duplicates = duplicate_triangles(mesh.triangles);
  mark_triangles(subject, sources, duplicates, "p1", " with the three vertices of an earlier one.");
  mark_triangles(subject, sources, degenerate_triangles(mesh), "p4",
                 " without area: a segment or a point.");
  const std::vector<OddEdge> edges = odd_edges(mesh.triangles, duplicates);
  mark_edges(subject, edges, EdgeDefect::boundary, "p0", "boundary edge of one triangle only.",
             "boundary edges of one triangle only.");
  mark_edges(subject, edges, EdgeDefect::non_manifold, "p3",
             "non-manifold edge of more than two triangles.",
             "non-manifold edges of more than two triangles.");
  mark_edges(subject, edges, EdgeDefect::twisted, "p2",
             "edge of two triangles that face opposite ways.",
             "edges of two triangles that face opposite ways.");
  if (edges.empty() && shells_inside_out(mesh, duplicates) != 0) {
    subject.warnings.push_back("inside out: normals face into the solid.");
  }
}

}  // namespace

Subject::Subject(const ImageFile& file) {
  mark_defects(file, *this);
}

}  // namespace flashbvh::tool
