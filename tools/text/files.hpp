// Files: read whole, written whole or not at all; text as lines of words.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "text/messages.hpp"

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

/// Letters of ASCII alone, in any locale.
std::string lower_case(std::string_view text);

/// The words between blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// Goes through a text line by line. LF, CR LF and CR end a line.
class Lines {
 public:
  /// `text` must outlive the object.
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Moves to the next line; false after the last.
  bool next();
  /// The same past lines that are empty or hold only a comment; a '#' ends a line.
  bool next_content();

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }   ///< from 1
  std::string_view rest() const { return rest_; }  ///< what lies after the line

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// read(line, place) of each line that has something in it. UserError if there is none: `empty`, "a
/// line".
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
