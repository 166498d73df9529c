// A baked tree as C++: constants and declarations in a header, constant arrays in a source file.
#ifndef FLASHBVH_TOOLS_IMAGE_CPP_WRITER_HPP
#define FLASHBVH_TOOLS_IMAGE_CPP_WRITER_HPP

#include <cstddef>
#include <string>

#include "bake/baked_tree.hpp"
#include "flashbvh/image.hpp"
#include "image/output_name.hpp"
#include "image/source_text.hpp"

namespace flashbvh::tool {

/// What firmware links that uses the default query on the C++ output: everything but the levels.
/// Bytes, on a 32-bit core.
template <class Index, Layout layout>
std::size_t flash_bytes(const bake::BakedTree<Index, layout>& baked);
/// The same, of the tree in an image.
std::uint64_t flash_bytes(const ImageHeader& header);

/// The arrays that `mesh` is a view of: kNodes, kTriangles and so on.
template <class Index, Layout layout>
std::string arrays_of_mesh(const bake::BakedTree<Index, layout>& baked);
/// The initialiser of that view. `scope`: what the arrays' names want before them, as in "palm::".
template <class Index, Layout layout>
std::string view_of_mesh(const bake::BakedTree<Index, layout>& baked, const std::string& scope);

/// `unit`: the name of the unit of length; empty if it is not known.
template <class Index, Layout layout>
SourceFiles cpp_of(const bake::BakedTree<Index, layout>& baked, const OutputName& name,
                   const std::string& unit);

}  // namespace flashbvh::tool

#endif
