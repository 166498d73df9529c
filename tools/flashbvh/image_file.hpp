// Reading binary images.
#ifndef FLASHBVH_TOOLS_IMAGE_FILE_HPP
#define FLASHBVH_TOOLS_IMAGE_FILE_HPP

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "flashbvh/image.hpp"

namespace flashbvh::tool {

/// Whatever the layout and the width of the indices.
using AnyTree =
    std::variant<LevelledPreTree, LevelledPostTree, LargeLevelledPreTree, LargeLevelledPostTree>;

/// An image in memory, opened and found good by the library.
class ImageFile {
 public:
  /// UserError if the file can't be read or is no good image.
  explicit ImageFile(const std::string& path);
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;

  const std::string& path() const { return path_; }
  /// The file's name without folder and extension.
  std::string name() const;
  const ImageHeader& header() const { return header_; }
  /// A view into the object.
  const AnyTree& tree() const { return tree_; }

  Layout layout() const { return static_cast<Layout>(header_.layout); }
  double cell() const;       ///< in the mesh's unit
  double deviation() const;  ///< likewise

 private:
  std::string path_;
  std::vector<std::uint32_t> words_;  ///< the bytes, aligned
  ImageHeader header_{};
  AnyTree tree_;
};

/// A point of the lattice, in cells of the mesh's frame: the vertex and the origin.
using LatticePoint = std::array<std::int64_t, 3>;

/// The corners of each triangle, in the order of the source mesh. UserError, naming the image, if
/// its triangle numbers are not each number once: the library can't tell that in constant memory.
std::vector<std::array<LatticePoint, 3>> source_triangles(const ImageFile& image);

/// "pre" or "post".
const char* layout_name(Layout layout);

}  // namespace flashbvh::tool

#endif
