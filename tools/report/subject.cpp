#include "report/subject.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "mesh/defects.hpp"
#include "mesh/units.hpp"
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
  subject.warnings.push_back({std::move(marks), triangle_list(places) + what});
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
    subject.warnings.push_back({std::move(marks), counted(count, one, many)});
  }
}

void mark_defects(Subject& subject, const std::vector<SourceTriangle>& sources) {
  const bake::LatticeMesh mesh = mesh_of(subject.image, sources);
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
  if (edges.empty() && is_inside_out(mesh, duplicates)) {
    subject.warnings.push_back({{"p2", {}}, "inside out: normals face into the solid."});
  }
}

}  // namespace

NodeBox root_box(const AnyTree& any) {
  return std::visit(
      [](const auto& tree) -> NodeBox {
        const std::int64_t x = tree.origin[0];
        const std::int64_t y = tree.origin[1];
        const std::int64_t z = tree.origin[2];
        const auto box = unpack(tree.nodes[0].box);
        return {{x + box.lower.x, y + box.lower.y, z + box.lower.z},
                {x + box.upper.x, y + box.upper.y, z + box.upper.z}};
      },
      any);
}

Subject::Subject(const ImageFile& file, std::size_t place, std::string unique_name)
    : image(file),
      number(place),
      name(std::move(unique_name)),
      flash(file.header().byte_count),
      box(root_box(file.tree())) {
  const std::vector<SourceTriangle> sources = source_triangles(file);
  left_out = sources.back().number + std::size_t{1} - sources.size();
  mark_defects(*this, sources);
}

Measure measure_of(const ImageFile& image) {
  const std::string unit = unit_name(image.unit());
  return {image.cell(), unit.empty() ? "" : " " + unit};
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
