#include "report/subject.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "mesh/defects.hpp"
#include "report/html.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// In the order of the source mesh; `numbers` are the triangles' there.
bake::LatticeMesh lattice_mesh(const ImageFile& image, std::vector<std::uint32_t>& numbers) {
  bake::LatticeMesh mesh;
  std::visit(
      [&](const auto& tree) {
        mesh.vertices.assign(tree.vertices, tree.vertices + tree.vertex_count);
      },
      image.tree());
  for (const SourceTriangle& triangle : source_triangles(image)) {
    mesh.triangles.push_back(triangle.vertices);
    numbers.push_back(triangle.number);
  }
  return mesh;
}

/// From places in the image to numbers in the source.
TriangleIds renumbered(TriangleIds places, const std::vector<std::uint32_t>& numbers) {
  for (std::uint32_t& place : places) {
    place = numbers[place];
  }
  return places;
}

std::vector<std::string> warnings_of(const bake::LatticeMesh& mesh,
                                     const std::vector<std::uint32_t>& numbers) {
  std::vector<std::string> warnings;
  const auto warn = [&](const TriangleIds& places, const char* what) {
    if (!places.empty()) {
      warnings.push_back(triangle_list(renumbered(places, numbers)) + what);
    }
  };
  const TriangleIds duplicates = duplicate_triangles(mesh.triangles);
  warn(degenerate_triangles(mesh), " without area: a segment or a point.");
  warn(duplicates, " with the three vertices of an earlier one.");
  const EdgeDefects defects = edge_defects(mesh.triangles, duplicates);
  if (defects.boundary != 0) {
    warnings.push_back(counted(defects.boundary, "boundary edge", "boundary edges") +
                       " of one triangle only.");
  }
  if (defects.non_manifold != 0) {
    warnings.push_back(counted(defects.non_manifold, "non-manifold edge", "non-manifold edges") +
                       " of more than two triangles.");
  }
  if (defects.twisted != 0) {
    warnings.push_back(counted(defects.twisted, "edge", "edges") +
                       " of two triangles that face opposite ways.");
  }
  const std::size_t left_out = numbers.back() + std::size_t{1} - numbers.size();
  if (left_out != 0) {
    warnings.push_back(counted(left_out, "triangle was", "triangles were") +
                       " left out when the mesh was baked; the others kept their numbers.");
  }
  return warnings;
}

}  // namespace

Subject::Subject(const ImageFile& file, std::size_t place, std::string unique_name)
    : image(file),
      number(place),
      name(std::move(unique_name)),
      shape(shape_of(file.tree())),
      box(std::visit([](const auto& tree) { return detail::unpack(tree.nodes[0].box); },
                     file.tree())) {
  std::vector<std::uint32_t> numbers;
  const bake::LatticeMesh mesh = lattice_mesh(file, numbers);
  for (const bake::TriangleCorners& t : mesh.triangles) {
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  warnings = warnings_of(mesh, numbers);
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
