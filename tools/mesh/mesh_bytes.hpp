// A mesh of a file as bytes, to pass it from one process of this program to another.
#ifndef FLASHBVH_TOOLS_MESH_MESH_BYTES_HPP
#define FLASHBVH_TOOLS_MESH_MESH_BYTES_HPP

#include <optional>
#include <string>
#include <string_view>

#include "mesh/mesh_builder.hpp"

namespace flashbvh::tool {

std::string bytes_of(const FileMesh& mesh);

/// Nothing if the bytes are not those of a mesh: a size, an index or a coordinate is wrong.
std::optional<FileMesh> mesh_of_bytes(std::string_view bytes);

}  // namespace flashbvh::tool

#endif
