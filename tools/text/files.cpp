#include "text/files.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 0xFFFFFFFF;  // of an input file

/// A name in the same folder, so that renaming stays within a file system.
fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  name += concat(".tmp", getpid());
  return name;
}

/// Removes all created files and folders, newest first, unless keep() was called.
class Rollback {
 public:
  ~Rollback() {
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
      std::error_code ignored;
      fs::remove(*path, ignored);  // removes a folder only if it is empty
    }
  }
  void made(const fs::path& path) { made_.push_back(path); }
  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

void make_folder(const fs::path& folder, Rollback& rollback) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) {
    return;
  }
  if (fs::exists(folder, error)) {
    throw UserError(folder.string(), "is no folder; write elsewhere");
  }
  make_folder(folder.parent_path(), rollback);
  if (fs::create_directory(folder, error)) {
    rollback.made(folder);
  } else if (error) {
    throw UserError(folder.string(), "can't be made: ", error.message(), "; write elsewhere");
  }
}

/// Writes to `path`; error messages use the user's `name` of the file.
void write_bytes(const fs::path& path, const fs::path& name, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    throw UserError(name.string(), "can't be written: ", std::strerror(errno));
  }
}

/// True for a name of standard output, which may be a file.
bool is_standard_output(const fs::path& path) {
  std::error_code error;
  return fs::equivalent(path, "/dev/stdout", error);
}

/// True for a device, a pipe or standard output: it receives the bytes, and no file may replace it.
bool is_special(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && (!fs::is_regular_file(status) || is_standard_output(path));
}

/// The file that a link leads to, so that no file replaces the link; other paths as they are.
/// UserError if the link leads to no file.
fs::path without_links(const fs::path& path) {
  std::error_code error;
  if (is_special(path) || !fs::is_symlink(fs::symlink_status(path, error))) {
    return path;
  }
  fs::path file = fs::canonical(path, error);
  if (error) {
    throw UserError(path.string(), "is a link that leads to no file: ", error.message(),
                    "; remove it or write elsewhere");
  }
  return file;
}

void write_to_standard_output(const fs::path& name, const std::string& bytes) {
  std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!std::cout.flush()) {
    throw UserError(name.string(), "can't be written");
  }
}

/// Renames the temporary file to the final name.
void put_in_place(const fs::path& path, Rollback& rollback) {
  std::error_code error;
  const bool is_new = !fs::exists(path, error);
  fs::rename(temporary_name(path), path, error);
  if (error) {
    throw UserError(path.string(), "can't be written: ", error.message());
  }
  if (is_new) {
    rollback.made(path);
  }
}

constexpr std::string_view kBlanks = " \t\v\f\r\n";

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    throw UserError(path, "is a folder; name a file");
  }
  if (fs::is_character_file(status) || fs::is_block_file(status)) {
    throw UserError(path, "is a device; name a file or a pipe");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw UserError(path, "can't be opened: ", std::strerror(errno));
  }
  std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
  std::string bytes;
  for (std::array<char, 0x10000> part{}; file && size <= kMostBytes;
       size = std::max<std::uintmax_t>(size, bytes.size())) {
    file.read(part.data(), part.size());
    bytes.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (size > kMostBytes) {
    throw UserError(path, "has 4 GiB or more; cut it in parts");
  }
  if (file.bad()) {
    throw UserError(path, "can't be read to its end");
  }
  if (bytes.empty()) {
    throw UserError(path, "is empty; write it again");
  }
  return bytes;
}

void refuse_to_replace_inputs(const std::string& output, const std::vector<std::string>& inputs) {
  std::error_code error;
  if (!fs::is_regular_file(output, error)) {
    return;
  }
  for (const std::string& input : inputs) {
    if (fs::equivalent(output, input, error)) {
      throw UserError(output, "would replace ", input, ", which is read; write elsewhere");
    }
  }
}

void FileSet::add(fs::path path, std::string bytes) {
  refuse_to_replace_inputs(path.string(), inputs_);
  path = without_links(path);
  const bool is_file = !is_special(path);
  if (is_file && !places_.insert(fs::absolute(path).lexically_normal()).second) {
    throw UserError(path.string(), "would be written twice; give each output a name of its own");
  }
  (is_file ? files_ : special_).push_back({std::move(path), std::move(bytes)});
}

void FileSet::write(const std::function<void()>& report) const {
  write_special();
  if (!files_.empty()) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error, so no file is left behind
  }
  Rollback rollback;
  for (const File& file : files_) {
    make_folder(file.path.parent_path(), rollback);
    const fs::path temporary = temporary_name(file.path);
    rollback.made(temporary);
    write_bytes(temporary, file.path, file.bytes);
  }
  report();
  flush_output();
  for (const File& file : files_) {
    put_in_place(file.path, rollback);
  }
  rollback.keep();
}

/// Comes before files that could be left behind.
void FileSet::write_special() const {
  for (const File& file : special_) {
    std::error_code error;
    if (fs::is_directory(file.path, error)) {
      throw UserError(file.path.string(), "is a folder; move it away or write elsewhere");
    }
    if (is_standard_output(file.path)) {
      write_to_standard_output(file.path, file.bytes);
    } else {
      write_bytes(file.path, file.path, file.bytes);
    }
  }
}

void write_file(const std::string& path, std::string bytes) {
  FileSet files;
  files.add(path, std::move(bytes));
  files.write();
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t at = line.find_first_not_of(kBlanks);
  while (at != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, at);
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

bool Lines::next() {
  if (rest_.empty()) {
    return false;
  }
  const std::size_t end = rest_.find_first_of("\r\n");
  line_ = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  ++number_;
  return true;
}

bool Lines::next_content() {
  while (next()) {
    line_ = line_.substr(0, line_.find('#'));
    if (line_.find_first_not_of(kBlanks) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace flashbvh::tool
