// The parts of an image's check: for open_image() and the tests.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/image.hpp"

namespace flashbvh::detail {

/// The element `offset` bytes from the start of an image.
template <class Element>
const Element* image_part(const void* bytes, uint64_t offset) {
  return reinterpret_cast<const Element*>(static_cast<const unsigned char*>(bytes) + offset);
}

/// Arrays that the paper's alternating rule needs in addition to a tree, of node_count elements
/// each; null if the image has none: see traversal/levels.hpp.
template <class Index>
struct ImageLevels {
  const Index* levels;  ///< the node's depth
  const Index* climb;   ///< pre-indexed: its parent; post-indexed: its right child level
};
template <class Index>
ImageLevels<Index> image_levels(const void* bytes);

/// CRC-32 (IEEE 802.3, reflected, as in zlib) of `size` bytes, going on from `crc` (0 at first).
/// By a table of 64 bytes: 10 instructions per byte on a Cortex-M4.
uint32_t crc32(const void* bytes, size_t size, uint32_t crc = 0);

/// Properties that follow from a mesh's contents; the header repeats them.
struct TreeShape {
  uint32_t depth;
  uint32_t stack_need;
  uint32_t leaf_size;
  uint32_t arity;
  uint32_t longest_edge;
  bool is_closed;
};

/// Checks a mesh's contents alone. Returns `done`, with the properties in `shape`, or
/// `image_invalid`. The counts and arrays must exist, for a post-indexed tree with or without the
/// levels; nothing else needs to be right.
template <class Index, Layout layout>
Status check_tree(const BasicMesh<Index, layout>& mesh, const ImageLevels<Index>& levels,
                  TreeShape& shape);

}  // namespace flashbvh::detail
