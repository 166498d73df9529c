// A baked tree as a binary image (flashbvh/image.hpp, lib/docs/format.md).
#ifndef FLASHBVH_TOOLS_IMAGE_WRITER_HPP
#define FLASHBVH_TOOLS_IMAGE_WRITER_HPP

#include <string>

#include "bake/baked_tree.hpp"

namespace flashbvh::tool {

/// The bytes of the image; a multiple of 4. UserError, naming `path`, if it would be over 4 GiB.
template <class Index, Layout layout>
std::string image_of(const bake::BakedTree<Index, layout>& baked, const std::string& path);

}  // namespace flashbvh::tool

#endif
