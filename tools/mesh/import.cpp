#include "mesh/import.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "mesh/limited_import.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct Format {
  std::string_view extension;  ///< with its point
  FileMesh (*read)(std::string_view, const std::string&);
};

FileMesh refuse_off(std::string_view, const std::string& file) {
  throw UserError(file, "is OFF, which is not read; convert it to STL, OBJ or PLY");
}

constexpr std::array<Format, 8> kFormats = {{{".stl", read_stl},
                                             {".obj", read_obj},
                                             {".ply", read_ply},
                                             {".off", refuse_off},
                                             {".dae", read_with_assimp},
                                             {".gltf", read_with_assimp},
                                             {".glb", read_with_assimp},
                                             {".3mf", read_3mf}}};

}  // namespace

const char* const kMeshFormats = "STL, OBJ, PLY, DAE, glTF, GLB, 3MF";

FileMesh import_mesh(const std::string& path, Warnings& warnings) {
  const std::string bytes = read_file(path);
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  const auto* const format =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&](const Format& known) { return known.extension == extension; });
  if (format == kFormats.end()) {
    throw UserError(path, "is no mesh by its extension; convert it to one of ", kMeshFormats);
  }
  const bool is_scene = format->read == read_with_assimp || format->read == read_3mf;
  if (is_scene && !std::filesystem::is_regular_file(path)) {
    throw UserError(path, "is a pipe, from which this format can't be read; name a file");
  }
  if (is_scene) {
    refuse_other_contents(bytes, path);
  }
  FileMesh mesh =
      limited_import([&] { return format->read(bytes, path); }, path, limits_of_file(bytes.size()));
  for (const std::string& warning : mesh.warnings) {
    warnings.add(path, warning);
  }
  return mesh;
}

double InputMesh::reading_error() const {
  return std::sqrt(3.0) * precision;
}

InputMesh input_of(std::string path, bake::SourceMesh mesh, TriangleIds degenerate,
                   double precision) {
  const bake::Extent extent = bake::extent_of(mesh);
  return {std::move(path),           std::move(mesh),       extent,
          bake::finest_cell(extent), std::move(degenerate), precision};
}

InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings) {
  FileMesh file = import_mesh(path, warnings);
  if (const std::string warning = units.contradiction(path, file.unit); !warning.empty()) {
    warnings.add(path, warning);
  }
  TriangleIds degenerate = degenerate_triangles(file.mesh);
  units.convert(file.mesh, path, file.unit);
  InputMesh input = input_of(path, std::move(file.mesh), std::move(degenerate),
                             units.converted(file.precision, path, file.unit));
  input.unit = file.unit;
  return input;
}

void check_units(const std::vector<InputMesh>& meshes, Warnings& warnings) {
  const auto carries = [](const InputMesh& mesh) { return mesh.unit != Unit::none; };
  const auto first = std::find_if(meshes.begin(), meshes.end(), carries);
  for (const InputMesh& mesh : meshes) {
    if (first != meshes.end() && carries(mesh) && mesh.unit != first->unit) {
      throw UserError(mesh.path, "carries the unit ", unit_name(mesh.unit), ", ", first->path, " ",
                      unit_name(first->unit), "; give the unit of the results, such as --unit mm");
    }
  }
  if (first != meshes.end() && !std::all_of(meshes.begin(), meshes.end(), carries)) {
    warnings.add(first->path, concat("carries the unit ", unit_name(first->unit),
                                     ", other files none; give the unit of the results, such as "
                                     "--unit mm"));
  }
}

}  // namespace flashbvh::tool
