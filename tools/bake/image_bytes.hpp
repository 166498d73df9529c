// A baked tree as a binary image (flashbvh/image.hpp, lib/docs/format.md).
#pragma once

#include <cstdint>
#include <vector>

#include "bake/baked_tree.hpp"

namespace flashbvh::bake {

/// The image's size in bytes; an image holds at most 2^32 - 4. `levels`: includes the levels of a
/// post-indexed tree; a pre-indexed image always has them.
template <class Index, Layout layout>
std::uint64_t image_size(const BakedTree<Index, layout>& baked, bool levels = false);

/// The image in words, so that it is aligned. Precondition: image_size() < 2^32.
template <class Index, Layout layout>
std::vector<std::uint32_t> image_of(const BakedTree<Index, layout>& baked, bool levels = false);

}  // namespace flashbvh::bake
