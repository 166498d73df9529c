#include "text/files.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 0xFFFFFFFF;  // of a file that is read

/// Beside the file itself, so that renaming stays within a file system.
fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  name += concat(".tmp", getpid());
  return name;
}

/// Takes back what was made, newest first, unless told to keep it.
class Rollback {
 public:
  ~Rollback() {
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
      std::error_code ignored;
      fs::remove(*path, ignored);  // a folder only if it is empty
    }
  }
  void made(const fs::path& path) { made_.push_back(path); }
  void keep() { made_.clear(); }

 private:
  std::vector<fs::path> made_;
};

void make_folder(const fs::path& folder, Rollback& rollback) {
  if (folder.empty() || fs::is_directory(folder)) {
    return;
  }
  make_folder(folder.parent_path(), rollback);
  std::error_code error;
  if (fs::create_directory(folder, error)) {
    rollback.made(folder);
  } else if (error) {
    throw UserError(folder.string(), "can't make this folder: ", error.message());
  }
}

/// `path` is where the bytes go, `name` how the user knows the file.
void write_bytes(const fs::path& path, const fs::path& name, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    throw UserError(name.string(), "can't be written: ", std::strerror(errno));
  }
}

/// A device or a pipe: it takes the bytes, and must not be replaced by a file.
bool is_special(const fs::path& path) {
  return fs::exists(path) && !fs::is_regular_file(path);
}

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

void FileSet::write() const {
  Rollback rollback;
  for (const File& file : files_) {
    make_folder(file.path.parent_path(), rollback);
    if (fs::is_directory(file.path)) {
      throw UserError(file.path.string(), "is a folder; move it away or write elsewhere");
    }
    if (is_special(file.path)) {
      write_bytes(file.path, file.path, file.bytes);
      continue;
    }
    const fs::path temporary = temporary_name(file.path);
    rollback.made(temporary);
    write_bytes(temporary, file.path, file.bytes);
  }
  for (const File& file : files_) {
    if (is_special(file.path)) {
      continue;
    }
    const bool is_new = !fs::exists(file.path);
    std::error_code error;
    fs::rename(temporary_name(file.path), file.path, error);
    if (error) {
      throw UserError(file.path.string(), "can't be written: ", error.message());
    }
    if (is_new) {
      rollback.made(file.path);
    }
  }
  rollback.keep();
}

void write_file(const std::string& path, std::string bytes) {
  FileSet files;
  files.add(path, std::move(bytes));
  files.write();
}

}  // namespace flashbvh::tool
