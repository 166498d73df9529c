// A baked tree as C++: constants and declarations in a header, constant arrays in a source file.
#ifndef FLASHBVH_TOOLS_IMAGE_CPP_WRITER_HPP
#define FLASHBVH_TOOLS_IMAGE_CPP_WRITER_HPP

#include <cstddef>
#include <string>

#include "bake/baked_tree.hpp"
#include "flashbvh/image.hpp"
#include "image/output_name.hpp"

namespace flashbvh::tool {

struct CppFiles {
  std::string header;  ///< NAME.fbvh.hpp
  std::string source;  ///< NAME.fbvh.cpp
};

/// What firmware links that uses the default query on the C++ output: everything but the levels.
/// Bytes, on a 32-bit core.
template <class Index, Layout layout>
std::size_t flash_bytes(const bake::BakedTree<Index, layout>& baked);
/// The same, of the tree in an image.
std::uint64_t flash_bytes(const ImageHeader& header);

/// The text of both files: the same for the same arguments, on every machine. `unit`: the name of
/// the unit of length; empty if it is not known.
template <class Index, Layout layout>
CppFiles cpp_of(const bake::BakedTree<Index, layout>& baked, const OutputName& name,
                const std::string& unit);

}  // namespace flashbvh::tool

#endif
