// Runs a reader that may crash, grow or never end in a separate process.
//
// A file's mesh passes from one process of this program to another as bytes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/guarded_child.hpp"
#include "mesh/mesh_builder.hpp"

namespace flashbvh::tool {

/// The end of messages about files that can't be read.
constexpr const char* kImportFix = "; export the mesh again, or as STL or PLY";

/// Runs `read` in a child process and returns its result. UserError, naming `file`, if `read`
/// throws one, crashes, ends the process, or exceeds a limit. Discards the child's output.
FileMesh guarded_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits& limits);

std::string bytes_of(const FileMesh& mesh);

/// None if the bytes are no mesh: a size, an index or a coordinate is wrong.
std::optional<FileMesh> mesh_of_bytes(std::string_view bytes);

}  // namespace flashbvh::tool
