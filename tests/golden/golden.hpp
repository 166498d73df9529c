// The images of the current format version that the repository keeps, and how to bake them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::test {

/// An image baked by this build.
struct BakedImage {
  std::string name;  ///< MESH-LAYOUT-BITS-BUILDER-LEAFSIZE-ARITY[-levels]
  std::vector<std::uint32_t> words;
};

/// All golden images: small, of several meshes, in both layouts and index widths, by both builders.
std::vector<BakedImage> bake_golden_images();

/// An image from the repository, aligned to 4 bytes.
struct KeptImage {
  const char* name;
  const unsigned char* bytes;
  std::size_t size;
};

/// tests/golden/*.fbvh, by name, embedded in the program.
extern const KeptImage kKeptImages[];
extern const std::size_t kKeptImageCount;

}  // namespace flashbvh::test
