// Runs work that may crash, grow or never end in a separate process.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace flashbvh::tool {

/// The limits of a reader.
struct ImportLimits {
  std::uint64_t bytes;        ///< of resident memory
  std::uint64_t cpu_seconds;  ///< of processor time
};

/// Generous: a file of this size needs a small part of it.
constexpr ImportLimits limits_of_file(std::uint64_t file_bytes) {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  return {1024 * kMebibyte + 64 * file_bytes, 60 + 4 * (file_bytes / kMebibyte)};
}

/// Runs `work` in a child process and returns the bytes that it writes to the file descriptor `to`.
/// UserError, naming `file` and ending in `fix`, if it crashes, ends with an exit code other than
/// 0, writes nothing, or exceeds a limit. Discards the child's output.
std::string guarded_bytes(const std::function<void(int to)>& work, const std::string& file,
                          const ImportLimits& limits, const char* fix);

/// Writes all bytes. Ends the process with exit code 1 on failure.
void send(std::string_view bytes, int to);

}  // namespace flashbvh::tool
