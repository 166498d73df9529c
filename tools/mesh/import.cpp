#include "mesh/import.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct Format {
  std::string_view extension;
  FileMesh (*read)(std::string_view, const std::string&);
};

constexpr std::array<Format, 8> kFormats = {{{"stl", read_stl},
                                             {"obj", read_obj},
                                             {"ply", read_ply},
                                             {"off", read_off},
                                             {"dae", read_with_assimp},
                                             {"gltf", read_with_assimp},
                                             {"glb", read_with_assimp},
                                             {"3mf", read_3mf}}};

/// A format that is not read, and the remedy.
struct Refusal {
  std::string_view extension;
  const char* what;
};

constexpr const char* kSolid = "is a model of CAD, not a mesh; export it as STL or 3MF from CAD";
constexpr const char* kRobot = "is a robot, not a mesh; bake its meshes one by one";

constexpr std::array<Refusal, 22> kRefusals = {
    {{"step", kSolid},    {"stp", kSolid},    {"stpz", kSolid},  {"iges", kSolid},
     {"igs", kSolid},     {"brep", kSolid},   {"fcstd", kSolid}, {"f3d", kSolid},
     {"sldprt", kSolid},  {"sldasm", kSolid}, {"ipt", kSolid},   {"iam", kSolid},
     {"catpart", kSolid}, {"prt", kSolid},    {"x_t", kSolid},   {"x_b", kSolid},
     {"3dm", kSolid},     {"scad", kSolid},   {"urdf", kRobot},  {"xacro", kRobot},
     {"sdf", kRobot},     {"srdf", kRobot}}};

/// Other formats of meshes and scenes that are not read: their names are refused as meshes.
constexpr std::array<std::string_view, 12> kUnread = {
    "blend", "fbx", "3ds", "wrl", "x3d", "amf", "usd", "usda", "usdc", "usdz", "dxf", "lwo"};

std::string lower_extension(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

/// Null if no entry has this extension.
template <class Table>
const typename Table::value_type* find(const Table& table, const std::string& extension) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const auto& known) { return known.extension == extension; });
  return found == table.end() ? nullptr : &*found;
}

InputMesh input_of(bake::SourceMesh mesh, const std::string& path, const FileMesh& file,
                   const Units& units) {
  const double precision = units.converted(file.precision, path, file.unit);
  InputMesh input = {path, {}, std::move(mesh), {}, precision, file.unit};
  input.degenerate = degenerate_triangles(input.mesh);
  units.convert(input.mesh, path, file.unit);
  return input;
}

FileMesh import_with(const Units& units, const std::string& path, Warnings& warnings) {
  FileMesh file = import_mesh(path, warnings);
  if (const std::string warning = units.contradiction(path, file.unit); !warning.empty()) {
    warnings.add(path, warning);
  }
  return file;
}

}  // namespace

const char* const kMeshFormats = "STL, OBJ, PLY, OFF, DAE, glTF, GLB, 3MF";

bool is_mesh_name(const std::string& path) {
  const std::string extension = lower_extension(path);
  return find(kFormats, extension) != nullptr || find(kRefusals, extension) != nullptr ||
         std::find(kUnread.begin(), kUnread.end(), extension) != kUnread.end();
}

FileMesh import_mesh(const std::string& path, Warnings& warnings) {
  const std::string bytes = read_file(path);
  const std::string extension = lower_extension(path);
  if (const Refusal* const refusal = find(kRefusals, extension)) {
    throw UserError(path, refusal->what);
  }
  const Format* const format = find(kFormats, extension);
  if (format == nullptr) {
    throw UserError(path, "is no mesh by its extension; convert it to one of ", kMeshFormats);
  }
  if (format->read == read_with_assimp) {
    refuse_other_contents(bytes, path);
  }
  FileMesh mesh = format->read(bytes, path);
  for (const std::string& warning : mesh.warnings) {
    warnings.add(path, warning);
  }
  return mesh;
}

double InputMesh::reading_error() const {
  return std::sqrt(3.0) * precision;
}

InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings) {
  FileMesh file = import_with(units, path, warnings);
  InputMesh input = input_of(std::move(file.mesh), path, file, units);
  input.bodies = std::move(file.bodies);
  return input;
}

std::vector<InputMesh> read_bodies(const std::string& path, const Units& units,
                                   Warnings& warnings) {
  const FileMesh file = import_with(units, path, warnings);
  std::vector<bake::SourceMesh> meshes = meshes_of_bodies(file);
  std::vector<InputMesh> inputs;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    inputs.push_back(input_of(std::move(meshes[i]), path, file, units));
    inputs.back().path = concat(path, ", body ", i, " ", tool::quoted(file.bodies[i]));
    inputs.back().bodies = {file.bodies[i]};
  }
  return inputs;
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
