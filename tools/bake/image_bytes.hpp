// A baked tree as a binary image (flashbvh/image.hpp, lib/docs/format.md).
#ifndef FLASHBVH_TOOLS_BAKE_IMAGE_BYTES_HPP
#define FLASHBVH_TOOLS_BAKE_IMAGE_BYTES_HPP

#include <cstdint>
#include <vector>

#include "bake/baked_tree.hpp"

namespace flashbvh::bake {

/// Bytes that the image takes. An image holds at most 2^32 - 4.
template <class Index, Layout layout>
std::uint64_t image_size(const BakedTree<Index, layout>& baked);

/// The image, in words, so that it lies aligned. Precondition: image_size(baked) < 2^32.
template <class Index, Layout layout>
std::vector<std::uint32_t> image_of(const BakedTree<Index, layout>& baked);

}  // namespace flashbvh::bake

#endif
