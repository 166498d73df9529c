#include "mesh/import.hpp"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <map>

#include "mesh/formats.hpp"
#include "mesh/polygon.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Position = std::array<double, 3>;

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension.empty() ? extension : extension.substr(1);
}

/// Of a format by its extension; null if there is none.
MeshText (*reader_of(const std::string& extension))(std::string, const std::string&) {
  return extension == "stl"   ? plain_stl
         : extension == "obj" ? plain_obj
         : extension == "off" ? plain_off
         : extension == "ply" ? plain_ply
                              : nullptr;
}

/// Gathers triangles and joins their corners by position.
class Gatherer {
 public:
  explicit Gatherer(const std::string& path) : path_(path) {}

  void add(const aiNode& node, const aiScene& scene, const aiMatrix4x4& above) {
    const aiMatrix4x4 transform = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      add(*scene.mMeshes[node.mMeshes[i]], transform);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      add(*node.mChildren[i], scene, transform);
    }
  }

  std::size_t face_count() const { return face_count_; }
  bake::SourceMesh finish() { return std::move(mesh_); }

 private:
  void add(const aiMesh& mesh, const aiMatrix4x4& transform) {
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      std::vector<Position> corners;
      for (unsigned j = 0; j < mesh.mFaces[i].mNumIndices; ++j) {
        corners.push_back(corner(mesh, mesh.mFaces[i].mIndices[j], transform));
      }
      if (corners.size() >= 3) {
        add(corners);
      }
    }
  }

  Position corner(const aiMesh& mesh, unsigned index, const aiMatrix4x4& transform) const {
    if (index >= mesh.mNumVertices) {
      throw UserError(path_, "polygon ", face_count_,
                      " has a corner at a vertex that is not there; export it again");
    }
    const aiVector3D& at = mesh.mVertices[index];
    const aiVector3D transformed = transform.IsIdentity() ? at : transform * at;
    const Position position = {static_cast<double>(transformed.x),
                               static_cast<double>(transformed.y),
                               static_cast<double>(transformed.z)};
    for (const double coordinate : position) {
      if (!std::isfinite(coordinate)) {
        throw UserError(path_, "polygon ", face_count_,
                        " (from 0) has a coordinate that is not a finite number; repair the mesh");
      }
    }
    return position;
  }

  void add(const std::vector<Position>& corners) {
    for (const auto& triangle : triangulate(corners)) {
      mesh_.triangles.push_back({joined(corners[triangle[0]]), joined(corners[triangle[1]]),
                                 joined(corners[triangle[2]])});
    }
    ++face_count_;
  }

  std::uint32_t joined(const Position& position) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [entry, inserted] = index_of_.emplace(position, next);
    if (inserted) {
      mesh_.vertices.push_back(position);
    }
    return entry->second;
  }

  const std::string& path_;
  bake::SourceMesh mesh_;
  std::map<Position, std::uint32_t> index_of_;
  std::size_t face_count_ = 0;
};

}  // namespace

bake::SourceMesh import_mesh(const std::string& path, Warnings& warnings) {
  std::string bytes = read_file(path);
  const std::string extension = lower_extension(path);
  const auto plain = reader_of(extension);
  if (plain == nullptr) {
    throw UserError(path, "is no .stl, .obj, .ply or .off file; convert the mesh to one of these");
  }
  const MeshText text = plain(std::move(bytes), path);
  if (!text.warning.empty()) {
    warnings.add(path, text.warning);
  }
  Assimp::Importer importer;
  const aiScene* const scene =
      importer.ReadFileFromMemory(text.bytes.data(), text.bytes.size(), 0, extension.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw UserError(path, "can't be read: ", one_line(importer.GetErrorString()),
                    "; export the mesh again");
  }
  Gatherer gatherer(path);
  gatherer.add(*scene->mRootNode, *scene, aiMatrix4x4());
  if (gatherer.face_count() != text.face_count) {
    throw UserError(path, "has ", text.face_count, " polygons, but ", gatherer.face_count(),
                    " could be read; export the mesh again");
  }
  return gatherer.finish();
}

InputMesh read_mesh(const std::string& path, const Units& units, Warnings& warnings) {
  InputMesh input = {path, import_mesh(path, warnings), {}};
  input.degenerate = degenerate_triangles(input.mesh);
  units.convert(input.mesh, path);
  return input;
}

}  // namespace flashbvh::tool
