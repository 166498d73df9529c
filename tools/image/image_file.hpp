// Reads binary images.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "bake/made_levels.hpp"
#include "bake/mesh.hpp"
#include "flashbvh/image.hpp"

namespace flashbvh::tool {

/// A mesh of any layout and width of indices.
using AnyTree =
    std::variant<PreMeshWithLevels, MeshWithLevels, PreMeshWithLevels32, MeshWithLevels32>;

/// The arrays of open_levelled().
using LevelArrays = std::variant<std::vector<std::uint16_t>, std::vector<std::uint32_t>>;

/// What messages say of the header of a mesh's or a robot's image.
struct HeaderFacts {
  std::size_t size;
  std::uint32_t byte_count;
  std::uint16_t version;
  std::uint16_t newest;  ///< version that this program reads
  const char* other;     ///< the message for other files
};

/// UserError, with the cause and the fix, if an image of `size` bytes did not open, or has more
/// bytes than its own.
void check_opened(Status status, const std::string& path, std::size_t size,
                  const HeaderFacts& header);

/// An image in memory, opened and validated by the library.
class ImageFile {
 public:
  /// UserError if the file can't be read or is no valid image.
  explicit ImageFile(const std::string& path);
  /// Opens the bytes of a file; `path` is its name for messages.
  ImageFile(const std::string& path, const std::string& bytes);
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;

  const std::string& path() const { return path_; }
  /// The file's name without folder and extension.
  std::string name() const;
  const ImageHeader& header() const { return header_; }
  /// header().byte_count bytes.
  const char* bytes() const { return reinterpret_cast<const char*>(words_.data()); }
  /// A view into the object. It has levels even if the image has none.
  const AnyTree& tree() const { return tree_; }

  Layout layout() const { return static_cast<Layout>(header_.layout); }
  double cell() const;       ///< in the mesh's unit
  double deviation() const;  ///< in the mesh's unit
  Unit unit() const { return static_cast<Unit>(header_.unit); }
  /// The mesh's name when it was baked.
  std::string source() const;

 private:
  std::string path_;
  std::vector<std::uint32_t> words_;  ///< the bytes, aligned
  ImageHeader header_{};
  LevelArrays levels_;
  AnyTree tree_;
};

/// A triangle by its number in the source mesh.
struct SourceTriangle {
  std::uint32_t number;
  std::array<std::uint32_t, 3> vertices;
};

/// In the order of the source mesh; numbers are missing if `bake` left triangles out. UserError,
/// naming the image, if a number occurs twice: the library cannot check that in constant memory.
std::vector<SourceTriangle> source_triangles(const ImageFile& image);

/// The image's vertices and these triangles of it, in cells from its own origin.
bake::LatticeMesh mesh_of(const ImageFile& image, const std::vector<SourceTriangle>& triangles);

/// "pre" or "post".
const char* layout_name(Layout layout);

}  // namespace flashbvh::tool
