// Runs a reader that may crash, grow or never end, under limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mesh/mesh_builder.hpp"

namespace flashbvh::tool {

/// The end of messages about files that can't be read.
constexpr const char* kImportFix = "; export the mesh again, or as STL or PLY";

/// The limits of a reader.
struct ImportLimits {
  std::uint64_t bytes;  ///< of memory, over what the program has
  unsigned seconds;
};

/// Generous: a file of this size needs a small part of it.
constexpr ImportLimits limits_of_file(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  return {1024 * kMebibyte + 64 * file_bytes,
          60 + 4 * static_cast<unsigned>(file_bytes / kMebibyte)};
}

/// The result of `read`. UserError, naming `file`, if `read` throws or takes too much memory. If
/// it crashes or takes too long, prints such a message and ends the program with exit code 2. One
/// call at a time.
FileMesh limited_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits& limits);

}  // namespace flashbvh::tool
