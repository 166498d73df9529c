// A baked image as C99: a constant array, and in a header what is known of it at compile time.
#ifndef FLASHBVH_TOOLS_IMAGE_C_WRITER_HPP
#define FLASHBVH_TOOLS_IMAGE_C_WRITER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "bake/baked_tree.hpp"
#include "image/output_name.hpp"
#include "image/source_text.hpp"

namespace flashbvh::tool {

/// `image`: of the tree, below 2 GiB. `unit`: the name of the unit of length; empty if it is not
/// known. All names in the text begin with the mesh's; no two of them are equal for two meshes,
/// since none ends in '_' and the rest of another.
template <class Index, Layout layout>
SourceFiles c_of(const bake::BakedTree<Index, layout>& baked,
                 const std::vector<std::uint32_t>& image, const OutputName& name,
                 const std::string& unit);

}  // namespace flashbvh::tool

#endif
