#include "robot/read/link_mesh.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include "mesh/import.hpp"
#include "robot/read/primitive_mesh.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

/// Finds `rest` in a folder `name` in `folder` or above it. Upper folders go by their real names.
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
                    "' is not next to the robot's file nor above it; say "
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

/// The file of `mesh` in the URDF `urdf`: a path relative to the URDF's folder, file://PATH,
/// package://NAME/REST or model://NAME/REST. NAME is a folder of `packages`, or else the first of
/// that name in the URDF's folder or upwards. So files may name any folder next to the URDF.
/// UserError, at `place`, if there is no such file.
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
                    "the robot's file and give its path");
  }
  const fs::path file = beside / rest;  // rest alone if it is absolute
  if (rest.empty() || !is_there(file)) {
    throw UserError(place, "the mesh '", one_line(mesh), "' is not there: no ", file.string(),
                    "; give its path from the robot's folder");
  }
  return file.string();
}

/// A collision element in its own frame.
struct Element {
  bake::SourceMesh mesh;
  std::string source;
  double precision = 0;
  std::string file = {};  ///< file that was read, if any
};

void check_positive(double length, const char* what, const std::string& place) {
  if (!(length > 0 && is_coordinate(length))) {
    throw UserError(place, "has ", what, " of ", shortest(length), "; give a positive length");
  }
}

Element round_element(const char* what, double length, PrimitiveMesh round) {
  return {std::move(round.mesh),
          concat(what, shortest(length), " m, up to ", significant(round.excess, 2), " m wider"),
          0};
}

Element primitive_element(const UrdfGeometry& shape, const std::string& place) {
  if (shape.shape == UrdfGeometry::Shape::box) {
    for (const double edge : shape.size) {
      check_positive(edge, "a box with an edge", place);
    }
    return {box_mesh(shape.size).mesh, "box", 0};
  }
  check_positive(shape.radius, "a radius", place);
  if (shape.shape == UrdfGeometry::Shape::sphere) {
    return round_element("sphere of radius ", shape.radius, sphere_mesh(shape.radius));
  }
  check_positive(shape.length, "a cylinder's length", place);
  return round_element("cylinder of radius ", shape.radius,
                       cylinder_mesh(shape.radius, shape.length));
}

/// Mirroring turns triangles inside out; this swaps their corners back.
void scale(bake::SourceMesh& mesh, const Vector3& factors) {
  for (Vector3& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] *= factors[i];
    }
  }
  if (factors[0] * factors[1] * factors[2] < 0) {
    for (bake::TriangleCorners& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

Element mesh_element(const UrdfGeometry& shape, const std::string& urdf, const Packages& packages,
                     const std::string& place, Warnings& warnings) {
  double largest = 0;
  for (const double factor : shape.size) {
    if (factor == 0) {
      throw UserError(place, "has a mesh with a scale of 0; give another");
    }
    largest = std::max(largest, std::fabs(factor));
  }
  const std::string file = find_mesh(shape.mesh, urdf, packages, place);
  FileMesh read;
  try {
    read = import_mesh(file, warnings);
  } catch (const UserError& error) {
    throw UserError(place, error.what());
  }
  const Units metres({"m"}, {});
  metres.convert(read.mesh, file, read.unit);
  scale(read.mesh, shape.size);
  return {std::move(read.mesh), shape.mesh,
          metres.converted(read.precision, file, read.unit) * largest, file};
}

void append(Element element, const Transform& placement, const std::string& place,
            ModelLink& made) {
  constexpr std::size_t kMost = 0xFFFFFFFF / 3;
  if (made.mesh.vertices.size() + element.mesh.vertices.size() > kMost ||
      made.mesh.triangles.size() + element.mesh.triangles.size() > kMost) {
    throw UserError(place, "has over ", kMost, " triangles or vertices; use fewer");
  }
  for (Vector3& vertex : element.mesh.vertices) {
    vertex = placed(placement, vertex);
    if (!std::all_of(vertex.begin(), vertex.end(), is_coordinate)) {
      throw UserError(place, "reaches over 3.4e38 m far; correct its origins and scales");
    }
  }
  made.source_begins.push_back(made.mesh.triangles.size());
  bake::append(element.mesh, made.mesh);
  made.sources.push_back(element.source);
  if (!element.file.empty()) {
    made.files.push_back(element.file);
  }
  made.precision = std::max(made.precision, element.precision);
}

}  // namespace

void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings) {
  const std::string place = at_element(urdf, "link", link.name);
  for (const UrdfCollision& collision : link.collisions) {
    const UrdfGeometry& shape = collision.geometry;
    Element element = shape.shape == UrdfGeometry::Shape::mesh
                          ? mesh_element(shape, urdf, packages, place, warnings)
                          : primitive_element(shape, place);
    append(std::move(element), composed(to_joint, collision.origin), place, made);
  }
}

}  // namespace flashbvh::tool
