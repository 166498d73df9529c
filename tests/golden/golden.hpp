// The images of this version of the format that are kept in the repository, and how they come
// about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::test {

/// An image as this build bakes it.
struct BakedImage {
  std::string name;  ///< MESH-LAYOUT-BITS-BUILDER-LEAFSIZE-ARITY[-levels]
  std::vector<std::uint32_t> words;
};

/// All of them, small: other meshes, both layouts and index widths, both builders.
std::vector<BakedImage> bake_golden_images();

/// An image as the repository has it, at a multiple of 4 bytes.
struct KeptImage {
  const char* name;
  const unsigned char* bytes;
  std::size_t size;
};

/// tests/golden/*.fbvh, by name, and answers.txt, built into the program: boards have no files.
extern const KeptImage kKeptImages[];
extern const std::size_t kKeptImageCount;
extern const char* const kKeptAnswers;

/// Every query of every traversal between any two images of one kind, translated and rotated:
/// counts, and the pairs of triangles. The text of answers.txt.
std::string answers_of(const KeptImage* images, std::size_t count);

}  // namespace flashbvh::test
