#include "robot/read/mesh_paths.hpp"

#include <filesystem>
#include <optional>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

/// REST in the folder NAME, wherever it is found first. Folders upwards by their real names.
std::optional<fs::path> find_upwards(const std::string& name, const std::string& rest,
                                     const fs::path& folder) {
  if (is_there(folder / name / rest)) {
    return folder / name / rest;
  }
  std::error_code unknown;
  for (fs::path at = fs::canonical(folder, unknown); at.has_relative_path();
       at = at.parent_path()) {
    if (at.filename() == name && is_there(at / rest)) {
      return at / rest;
    }
    if (is_there(at.parent_path() / name / rest)) {
      return at.parent_path() / name / rest;
    }
  }
  return std::nullopt;
}

std::string find_in_package(const std::string& mesh, const std::string& name_and_rest,
                            const fs::path& folder, const Packages& packages,
                            const std::string& place) {
  const std::size_t slash = name_and_rest.find('/');
  const std::string name = name_and_rest.substr(0, slash);
  const std::string rest = slash == std::string::npos ? "" : name_and_rest.substr(slash + 1);
  const auto known = packages.find(name);
  if (known == packages.end()) {
    if (const std::optional<fs::path> found = find_upwards(name, rest, folder)) {
      return found->string();
    }
    throw UserError(place, "the mesh '", one_line(mesh),
                    "' is not next to the URDF nor above it; say "
                    "where the package is by --package ",
                    name, "=DIR");
  }
  const fs::path file = fs::path(known->second) / rest;
  if (!is_there(file)) {
    throw UserError(place, "the mesh '", one_line(mesh), "' is not there: no ", file.string(),
                    "; give another --package ", name, "=DIR");
  }
  return file.string();
}

}  // namespace

std::string find_mesh(const std::string& mesh, const std::string& urdf, const Packages& packages,
                      const std::string& place) {
  const fs::path beside = fs::path(urdf).parent_path();
  const fs::path folder = beside.empty() ? fs::path(".") : beside;
  const std::size_t scheme = mesh.find("://");
  const std::string kind = scheme == std::string::npos ? "" : mesh.substr(0, scheme);
  const std::string rest = scheme == std::string::npos ? mesh : mesh.substr(scheme + 3);
  if (kind == "package" || kind == "model") {
    return find_in_package(mesh, rest, folder, packages, place);
  }
  if (!kind.empty() && kind != "file") {
    throw UserError(place, "the mesh '", one_line(mesh),
                    "' is not on this machine; store it next to "
                    "the URDF and give its path");
  }
  const fs::path file = beside / rest;  // rest alone if it is absolute
  if (rest.empty() || !is_there(file)) {
    throw UserError(place, "the mesh '", one_line(mesh), "' is not there: no ", file.string(),
                    "; give its path from the URDF's folder");
  }
  return file.string();
}

}  // namespace flashbvh::tool
