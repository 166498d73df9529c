// Reads whole files; writes files completely or not at all; splits text into lines and words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/messages.hpp"

namespace flashbvh::tool {

/// The bytes of a file or of a pipe. UserError if it can't be read, is empty, has 4 GiB or more, or
/// is a device, which may have no end.
std::string read_file(const std::string& path);

/// UserError if the file `output` is one of `inputs`, under any name.
void refuse_to_replace_inputs(const std::string& output, const std::vector<std::string>& inputs);

/// Files that belong together: either all of them are written or none.
class FileSet {
 public:
  /// `inputs`: files that were read.
  explicit FileSet(std::vector<std::string> inputs = {}) : inputs_(std::move(inputs)) {}

  /// Adds a file, for a link the one that it leads to; writes nothing yet. UserError if it would
  /// replace an input, the path was added before, or a link leads to no file.
  void add(std::filesystem::path path, std::string bytes);

  /// Writes every file under a temporary name next to its own, calls `report`, flushes standard
  /// output, then renames all. Makes missing folders. On failure it throws and removes all new
  /// files, unless a rename failed after another had replaced an older file. Files that are not
  /// regular, and standard output, get their bytes first.
  void write(const std::function<void()>& report = [] {}) const;

 private:
  struct File {
    std::filesystem::path path;
    std::string bytes;
  };
  void write_special() const;

  std::vector<std::string> inputs_;
  std::vector<File> files_;
  std::vector<File> special_;               ///< standard output, devices, pipes
  std::set<std::filesystem::path> places_;  ///< normalized paths of files_, to find duplicates
};

/// The bytes of an image's words.
inline std::string as_bytes(const std::vector<std::uint32_t>& words) {
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]};
}

/// Writes a single file.
void write_file(const std::string& path, std::string bytes);

/// Converts ASCII letters only, in any locale.
std::string lower_case(std::string_view text);

/// The words of a line, separated by blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// Iterates over the lines of a text, after its byte order mark if it has one. LF, CR LF and CR end
/// a line.
class Lines {
 public:
  /// `text` must outlive the object.
  explicit Lines(std::string_view text)
      : rest_(text.substr(text.substr(0, kMark.size()) == kMark ? kMark.size() : 0)) {}

  /// Moves to the next line; false after the last.
  bool next();
  /// Moves to the next line with content; skips empty lines and comments, which begin with '#'.
  bool next_content();

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }   ///< from 1
  std::string_view rest() const { return rest_; }  ///< the text after the line

 private:
  static constexpr std::string_view kMark = "\xEF\xBB\xBF";

  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// Calls read(line, place) for each line with content. UserError if there is none; `empty`, such as
/// "a line", is for its message.
template <class Thing, class Read>
std::vector<Thing> read_lines(const std::string& path, const std::string& empty, const Read& read) {
  const std::string text = read_file(path);
  std::vector<Thing> things;
  for (Lines lines(text); lines.next_content();) {
    things.push_back(read(lines.line(), at_line(path, lines.number())));
  }
  if (things.empty()) {
    throw UserError(path, empty, " a line");
  }
  return things;
}

}  // namespace flashbvh::tool
