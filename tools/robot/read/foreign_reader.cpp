// Needs POSIX, and Linux's /proc to find this program's folder.
#include "robot/read/foreign_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "mesh/guarded_child.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

/// Next to this program in a build, or in libexec after installation.
std::string reader_of(const ForeignForm& form, const std::string& path) {
  std::error_code unknown;
  const fs::path folder = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const fs::path& place : {folder, folder.parent_path() / "libexec/flashbvh"}) {
    if (access((place / form.reader).c_str(), X_OK) == 0) {
      return (place / form.reader).string();
    }
  }
  throw UserError(path, "is ", form.name, ", whose reader is missing: no ", form.reader, " in ",
                  folder.string(), "; install flashbvh again, or convert the file to a URDF");
}

/// The reader loads the robot's meshes, too, from any folder.
ImportLimits limits_of_robot() {
  constexpr std::uint64_t kMebibyte = 1 << 20;
  return {2048 * kMebibyte, 120};
}

}  // namespace

std::string text_of_reader(const ForeignForm& form, const std::string& path) {
  const std::string reader = reader_of(form, path);
  const auto run = [&](int to) {
    dup2(to, STDOUT_FILENO);
    execl(reader.c_str(), reader.c_str(), path.c_str(), nullptr);
    _exit(1);
  };
  return guarded_bytes(run, path, limits_of_robot(), kForeignFix);
}

}  // namespace flashbvh::tool
