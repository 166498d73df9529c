// The readers of mesh files.
//
// STL, OBJ, PLY and OFF are read here: strictly, in double precision, each number of a text as the
// double nearest to it, each number of a binary as it is. assimp reads the others. It repairs what
// it cannot read and reports that in its log alone, and its coordinates are 32-bit floats.
#ifndef FLASHBVH_TOOLS_MESH_FORMATS_HPP
#define FLASHBVH_TOOLS_MESH_FORMATS_HPP

#include <string>
#include <string_view>

#include "mesh/mesh_builder.hpp"

namespace flashbvh::tool {

// Each takes the bytes of a file and its name for messages. UserError if the file is damaged or of
// another format, or has no polygons.

/// Binary and ASCII. A body is a `solid`.
FileMesh read_stl(std::string_view bytes, const std::string& file);
/// A body is what the last `o` or `g` line names.
FileMesh read_obj(std::string_view bytes, const std::string& file);
/// One body.
FileMesh read_off(std::string_view bytes, const std::string& file);
/// ASCII and binary. One body.
FileMesh read_ply(std::string_view bytes, const std::string& file);

/// The formats that assimp reads, from the file itself, for what it may refer to. A body is a node.
FileMesh read_with_assimp(std::string_view bytes, const std::string& file);

/// Warns if a text file does not end with a line end: its last number may have lost digits, which
/// nothing else shows.
void warn_of_cut_line(std::string_view text, FileMesh& mesh);

}  // namespace flashbvh::tool

#endif
