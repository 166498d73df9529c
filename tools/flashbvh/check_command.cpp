// flashbvh check: proves that an image is well-formed, and that it is a certain mesh.
//
// An image is a mesh if, rounded with the image's cell, triangle by triangle in the order of the
// file, the mesh has the same corners as the image.
#include <iostream>
#include <memory>

#include "bake/quantise.hpp"
#include "flashbvh/commands.hpp"
#include "flashbvh/image_file.hpp"
#include "flashbvh/mesh_import.hpp"

namespace flashbvh::tool {
namespace {

std::string text_of(const LatticePoint& point) {
  return "(" + std::to_string(point[0]) + " " + std::to_string(point[1]) + " " +
         std::to_string(point[2]) + ")";
}

LatticePoint point_of(const bake::LatticeMesh& mesh, std::uint32_t vertex) {
  const Vertex& v = mesh.vertices[vertex];
  return {std::int64_t{v.x} + mesh.origin[0], std::int64_t{v.y} + mesh.origin[1],
          std::int64_t{v.z} + mesh.origin[2]};
}

/// The first difference; empty if there is none.
std::string difference(const std::vector<std::array<LatticePoint, 3>>& triangles, double cell,
                       const bake::SourceMesh& mesh) {
  if (triangles.size() != mesh.triangles.size()) {
    return "the image has " + std::to_string(triangles.size()) + " triangles, the mesh " +
           std::to_string(mesh.triangles.size());
  }
  if (!bake::fits(mesh, cell)) {
    return "the mesh is too large for the image's cell";
  }
  const bake::LatticeMesh rounded = bake::round_to_lattice(mesh, cell);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const LatticePoint wanted = point_of(rounded, rounded.triangles[i][corner]);
      if (triangles[i][corner] != wanted) {
        return "corner " + std::to_string(corner) + " of triangle " + std::to_string(i) +
               " lies at " + text_of(triangles[i][corner]) + " in the image, at " +
               text_of(wanted) + " in the mesh";
      }
    }
  }
  return {};
}

ExitCode check(const std::string& path, const std::string& mesh_path) {
  const ImageFile image(path);
  const auto triangles = source_triangles(image);
  std::string verdict = "well-formed, " + std::to_string(triangles.size()) + " triangles, " +
                        std::to_string(image.header().node_count) + " nodes";
  ExitCode exit_code = kSuccess;
  if (!mesh_path.empty()) {
    const std::string found = difference(triangles, image.cell(), import_mesh(mesh_path));
    verdict += found.empty() ? ", equal to " + mesh_path : ", but not " + mesh_path + ": " + found;
    exit_code = found.empty() ? kSuccess : kCheckFailed;
  }
  std::cout << image.name() << ": " << verdict << "\n";
  return exit_code;
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  struct Arguments {
    std::string image;
    std::string mesh;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand(
      "check",
      "Prove that an image is well-formed and, with --mesh, that it is this mesh.\n"
      "Exits with 1 if it is another one.");
  command->add_option("IMAGE", arguments->image, "Image (.fbvh)")->required();
  command->add_option("--mesh", arguments->mesh, "The mesh file that it was baked from");
  command->callback(
      [arguments, &exit_code] { exit_code = check(arguments->image, arguments->mesh); });
}

}  // namespace flashbvh::tool
