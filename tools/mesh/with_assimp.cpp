// Formats that assimp reads: the meshes of a scene's nodes, placed by the nodes. Runs in a separate
// process: damaged files make assimp abort, read out of bounds, and take all memory.
#include <assimp/config.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "mesh/guarded_import.hpp"
#include "mesh/mesh_builder.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Rows of a rotation and scale with a translation, in double precision: placing a mesh adds no
/// rounding that matters.
using Placement = std::array<std::array<double, 4>, 3>;

constexpr Placement kIdentity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// The node's own placement, then `outer`.
Placement placed(const Placement& outer, const aiMatrix4x4& own) {
  Placement product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      product[row][column] = column == 3 ? outer[row][3] : 0;
      for (unsigned k = 0; k < 3; ++k) {
        product[row][column] += outer[row][k] * static_cast<double>(own[k][column]);
      }
    }
  }
  return product;
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
    mesh.precision = half_ulp(largest_);
    return mesh;
  }

 private:
  void add(const aiNode& node, const Placement& outer) {
    const Placement placement = placed(outer, node.mTransformation);
    if (node.mNumMeshes != 0) {
      builder_.begin_body({node.mName.data, node.mName.length});
    }
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      add(*scene_.mMeshes[node.mMeshes[i]], placement);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      add(*node.mChildren[i], placement);
    }
  }

  void add(const aiMesh& mesh, const Placement& placement) {
    const auto first = static_cast<std::uint32_t>(builder_.point_count());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      builder_.add_point(point(mesh.mVertices[i], placement));
    }
    std::vector<std::uint32_t> corners;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices < 3) {
        builder_.leave_out();
        continue;
      }
      corners.clear();
      for (unsigned j = 0; j < face.mNumIndices; ++j) {
        if (face.mIndices[j] >= mesh.mNumVertices) {
          throw UserError(file_, "a corner at vertex ", face.mIndices[j], " of ", mesh.mNumVertices,
                          "; export the mesh again");
        }
        corners.push_back(first + face.mIndices[j]);
      }
      builder_.add_polygon(corners);
    }
  }

  Position point(const aiVector3D& at, const Placement& placement) {
    Position point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& row = placement[axis];
      const std::array<double, 4> parts = {row[0] * static_cast<double>(at.x),
                                           row[1] * static_cast<double>(at.y),
                                           row[2] * static_cast<double>(at.z), row[3]};
      double size = 0;
      for (const double part : parts) {
        point[axis] += part;
        size += std::fabs(part);
      }
      if (!is_coordinate(size)) {
        throw UserError(file_,
                        "has a coordinate that is no finite number of at most 3.4e38; repair "
                        "the mesh");
      }
      largest_ = std::max(largest_, size);
    }
    return point;
  }

  const aiScene& scene_;
  const std::string& file_;
  MeshBuilder builder_;
  double largest_ = 0;  ///< largest sum of a coordinate's absolute summands
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
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  const aiScene* const scene = importer.ReadFile(file, 0);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string said = one_line(importer.GetErrorString());
    throw UserError(file, "can't be read: ",
                    said == "std::bad_alloc" ? "takes more memory than there is" : said,
                    "; export the mesh again");
  }
  return SceneReader(*scene, file).read();
}

}  // namespace

FileMesh read_with_assimp(std::string_view bytes, const std::string& file) {
  if (bytes.substr(0, 5) == "glTF\1") {
    throw UserError(file, "is of glTF 1; export it as glTF 2");  // assimp reads it wrongly
  }
  if (!std::filesystem::is_regular_file(file)) {
    throw UserError(file, "is a pipe, from which this format can't be read; name a file");
  }
  return guarded_import([&] { return read_scene(file); }, file, limits_of_file(bytes.size()));
}

}  // namespace flashbvh::tool
