// Formats that assimp reads: the meshes of a scene's nodes, placed by the nodes. Damaged files make
// assimp abort, read out of bounds, and take all memory.
#include <assimp/config.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <new>
#include <vector>

#include "mesh/mesh_builder.hpp"
#include "mesh/scene_checks.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

Placement placement_of(const aiMatrix4x4& matrix) {
  Placement placement{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      placement[row][column] = static_cast<double>(matrix[static_cast<unsigned>(row)][column]);
    }
  }
  return placement;
}

/// A bound on the distance of a number of this size from the nearest float.
double half_ulp(double size) {
  constexpr auto kLeast = static_cast<double>(std::numeric_limits<float>::min());
  return std::ldexp(1.0, std::ilogb(std::max(size, kLeast)) - 24);
}

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& file)
      : scene_(scene), file_(file), builder_(file) {}

  FileMesh read() {
    add(*scene_.mRootNode, kIdentity);
    FileMesh mesh = builder_.finish();
    mesh.precision = half_ulp(builder_.largest());
    return mesh;
  }

 private:
  void add(const aiNode& node, const Placement& outer) {
    const Placement placement = composed(outer, placement_of(node.mTransformation));
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      add(*scene_.mMeshes[node.mMeshes[i]], placement);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      add(*node.mChildren[i], placement);
    }
  }

  void add(const aiMesh& mesh, const Placement& placement) {
    builder_.begin_part(placement);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& at = mesh.mVertices[i];
      builder_.add_point(
          {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)});
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      const std::vector<std::uint32_t> corners(face.mIndices, face.mIndices + face.mNumIndices);
      if (corners.size() < 3) {
        builder_.leave_out();
        continue;
      }
      if (const auto last = *std::max_element(corners.begin(), corners.end());
          last >= mesh.mNumVertices) {
        throw UserError(file_, "a corner at vertex ", last, " of ", mesh.mNumVertices,
                        "; export the mesh again");
      }
      builder_.add_polygon(corners);
    }
  }

  const aiScene& scene_;
  const std::string& file_;
  MeshBuilder builder_;
};

/// Opens regular files alone: a file may refer to a device or a pipe without end.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* file) const override {
    std::error_code missing;
    return std::filesystem::is_regular_file(file, missing);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return Exists(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }
};

FileMesh read_scene(const std::string& file) {
  Assimp::Importer importer;
  importer.SetIOHandler(new RegularFiles);  // owned by the importer
  // Viewers of robot models ignore the up axis of Collada, and models are drawn for them.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* const scene = importer.ReadFile(file, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string said = one_line(importer.GetErrorString());
    if (said == "std::bad_alloc") {
      throw std::bad_alloc();
    }
    throw UserError(file, "can't be read: ", said, "; export the mesh again");
  }
  return SceneReader(*scene, file).read();
}

}  // namespace

FileMesh read_with_assimp(std::string_view bytes, const std::string& file) {
  if (bytes.substr(0, 5) == "glTF\1") {
    throw UserError(file, "is of glTF 1; export it as glTF 2");  // assimp reads it wrongly
  }
  const std::string kind = lower_case(std::filesystem::path(file).extension().string());
  const bool is_gltf = kind == ".gltf" || kind == ".glb";
  if (kind == ".dae") {
    check_collada(bytes, file);
  }
  const GltfContents contents = is_gltf ? check_gltf(bytes, file) : GltfContents();
  FileMesh mesh = read_scene(file);
  if (is_gltf && mesh.mesh.triangles.size() != contents.triangles) {
    throw UserError(file, "has ", contents.triangles, " triangles, of which assimp reads ",
                    mesh.mesh.triangles.size(),
                    ": others have corners at no vertex; export the mesh again");
  }
  mesh.warnings.insert(mesh.warnings.end(), contents.warnings.begin(), contents.warnings.end());
  mesh.unit = Unit::m;  // assimp applies the unit of a DAE
  return mesh;
}

}  // namespace flashbvh::tool
