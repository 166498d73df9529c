#include "report/subject.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "mesh/defects.hpp"
#include "report/html.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// `places`: in the image's order of sources; the warning has their numbers in the source mesh.
void mark_triangles(Subject& subject, TriangleIds places, Paint paint, const char* what) {
  if (places.empty()) {
    return;
  }
  for (std::uint32_t& place : places) {
    subject.triangles[place].paint = paint;
    place = subject.triangles[place].source.number;
  }
  subject.warnings.push_back({paint, triangle_list(places) + what});
}

void mark_edges(Subject& subject, const std::vector<OddEdge>& edges, EdgeDefect defect, Paint paint,
                const char* one, const char* many) {
  const std::vector<LatticePoint> points = vertices_of(subject.image.tree());
  std::size_t count = 0;
  for (const auto& [vertices, found] : edges) {
    if (found == defect) {
      const LatticePoint& to = points[vertices[1]];
      subject.marked_edges.push_back({{points[vertices[0]], to, to}, paint});
      ++count;
    }
  }
  if (count != 0) {
    subject.warnings.push_back({paint, counted(count, one, many)});
  }
}

void mark_defects(Subject& subject, const bake::LatticeMesh& mesh) {
  const TriangleIds duplicates = duplicate_triangles(mesh.triangles);
  mark_triangles(subject, duplicates, kDuplicate, " with the three vertices of an earlier one.");
  mark_triangles(subject, degenerate_triangles(mesh), kNoArea,
                 " without area: a segment or a point.");
  const std::vector<OddEdge> edges = odd_edges(mesh.triangles, duplicates);
  mark_edges(subject, edges, EdgeDefect::boundary, kBoundary, "boundary edge of one triangle only.",
             "boundary edges of one triangle only.");
  mark_edges(subject, edges, EdgeDefect::non_manifold, kNonManifold,
             "non-manifold edge of more than two triangles.",
             "non-manifold edges of more than two triangles.");
  mark_edges(subject, edges, EdgeDefect::twisted, kTwisted,
             "edge of two triangles that face opposite ways.",
             "edges of two triangles that face opposite ways.");
}

}  // namespace

Subject::Subject(const ImageFile& file, std::size_t place, std::string unique_name)
    : image(file),
      number(place),
      name(std::move(unique_name)),
      flash(file.header().byte_count),
      box(std::visit([](const auto& tree) { return node_box(tree, 0); }, file.tree())) {
  const std::vector<LatticePoint> points = vertices_of(file.tree());
  const std::vector<SourceTriangle> sources = source_triangles(file);
  const bake::LatticeMesh mesh = mesh_of(file, sources);
  const bool solid = is_solid(mesh);
  for (const SourceTriangle& source : sources) {
    const auto& [p, q, r] = source.vertices;
    triangles.push_back({{{points[p], points[q], points[r]}, kFirstMesh, solid}, source});
  }
  left_out = sources.back().number + std::size_t{1} - sources.size();
  mark_defects(*this, mesh);
}

std::vector<std::string> unique_names(const std::vector<std::string>& paths) {
  std::map<std::string, std::size_t> seen;
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const std::string name = std::filesystem::path(path).stem().string();
    const std::size_t before = seen[name]++;
    names.push_back(before == 0 ? name : concat(name, " (", before + 1, ")"));
  }
  return names;
}

}  // namespace flashbvh::tool
