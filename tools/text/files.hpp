// Files: read whole, written whole or not at all.
#ifndef FLASHBVH_TOOLS_TEXT_FILES_HPP
#define FLASHBVH_TOOLS_TEXT_FILES_HPP

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flashbvh::tool {

/// The bytes of a file or of a pipe. UserError if it can't be read, is empty or of 4 GiB or more,
/// or is a device, which may have no end.
std::string read_file(const std::string& path);

/// Files that belong together: either all of them get written or none.
class FileSet {
 public:
  /// Adds a file; nothing is written yet. UserError if there is one of that path.
  void add(std::filesystem::path path, std::string bytes);

  /// Writes every file under a temporary name next to its own, calls `report`, then renames them
  /// all; makes their folder if there is none. UserError if that fails; then, or if `report`
  /// throws, what it made is gone again, unless a rename failed behind another that replaced an
  /// older file. Signals that end the program wait for that, too. What is no regular file gets its
  /// bytes first.
  void write(const std::function<void()>& report = [] {}) const;

 private:
  struct File {
    std::filesystem::path path;
    std::string bytes;
  };
  void write_special() const;

  std::vector<File> files_;
  std::set<std::filesystem::path> places_;  ///< of files_, each written in one way
};

/// One file alone.
void write_file(
    const std::string& path, std::string bytes, const std::function<void()>& report = [] {});

}  // namespace flashbvh::tool

#endif
