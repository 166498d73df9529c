#include "robot/read/link_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "mesh/import.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

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

/// The file that `mesh` means in the URDF `urdf`: a path, relative to the URDF's folder, one behind
/// file://, or package://NAME/REST and model://NAME/REST. The folder NAME is that of `packages`, or
/// else the first of that name, looked for in the URDF's folder and upwards; so it may be any
/// folder next to the URDF, as in files that call no package by its name. UserError, at `place`, if
/// there is no such file.
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
  std::string file = {};  ///< that was read, if any
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
  if (shape.shape == UrdfGeometry::Shape::ellipsoid) {
    for (const double width : shape.size) {
      check_positive(width, "an ellipsoid with a width", place);
    }
    return round_element("ellipsoid of width ",
                         *std::max_element(shape.size.begin(), shape.size.end()),
                         ellipsoid_mesh(shape.size));
  }
  check_positive(shape.radius, "a radius", place);
  if (shape.shape == UrdfGeometry::Shape::sphere) {
    return round_element("sphere of radius ", shape.radius, sphere_mesh(shape.radius));
  }
  const bool is_capsule = shape.shape == UrdfGeometry::Shape::capsule;
  check_positive(shape.length, is_capsule ? "a capsule's length" : "a cylinder's length", place);
  return is_capsule ? round_element("capsule of radius ", shape.radius,
                                    capsule_mesh(shape.radius, shape.length))
                    : round_element("cylinder of radius ", shape.radius,
                                    cylinder_mesh(shape.radius, shape.length));
}

/// A mirrored mesh is turned outside in; its triangles are turned back.
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
  scale(read.mesh, shape.size);
  return {std::move(read.mesh), shape.mesh, read.precision * largest, file};
}

void append(const Element& element, const Transform& placement, const std::string& place,
            ModelLink& made) {
  const std::size_t first = made.mesh.vertices.size();
  constexpr std::size_t kMost = 0xFFFFFFFF / 3;
  if (first + element.mesh.vertices.size() > kMost ||
      made.mesh.triangles.size() + element.mesh.triangles.size() > kMost) {
    throw UserError(place, "has over ", kMost, " triangles or vertices; use fewer");
  }
  for (const Vector3& vertex : element.mesh.vertices) {
    made.mesh.vertices.push_back(placed(placement, vertex));
    for (const double coordinate : made.mesh.vertices.back()) {
      if (!is_coordinate(coordinate)) {
        throw UserError(place, "reaches over 3.4e38 m far; correct its origins and scales");
      }
    }
  }
  made.source_begins.push_back(made.mesh.triangles.size());
  for (bake::TriangleCorners corners : element.mesh.triangles) {
    for (std::uint32_t& corner : corners) {
      corner += static_cast<std::uint32_t>(first);
    }
    made.mesh.triangles.push_back(corners);
  }
  made.sources.push_back(element.source);
  if (!element.file.empty()) {
    made.files.push_back(element.file);
  }
  made.precision = std::max(made.precision, element.precision);
}

/// More than what rounding of coordinates takes from a radius.
constexpr double kRoundingMargin = 1 + 0x1p-48;

Vector3 scaled(const Vector3& v, double factor) {
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}
Vector3 sum(const Vector3& v, const Vector3& w) {
  return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}
double dot(const Vector3& v, const Vector3& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
Vector3 unit(const Vector3& v) {
  return scaled(v, 1 / std::sqrt(dot(v, v)));
}

/// Each triangle becomes four, corners on the unit sphere.
void cut(bake::SourceMesh& sphere) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(sphere.vertices.size());
    const auto [found, is_new] = middles.emplace(std::minmax(a, b), next);
    if (is_new) {
      sphere.vertices.push_back(unit(sum(sphere.vertices[a], sphere.vertices[b])));
    }
    return found->second;
  };
  std::vector<bake::TriangleCorners> cut;
  for (const auto& [a, b, c] : sphere.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    cut.insert(cut.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  sphere.triangles = std::move(cut);
}

bake::SourceMesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  bake::SourceMesh mesh;
  for (const Vector3& v : {Vector3{-1, g, 0},
                           {1, g, 0},
                           {-1, -g, 0},
                           {1, -g, 0},
                           {0, -1, g},
                           {0, 1, g},
                           {0, -1, -g},
                           {0, 1, -g},
                           {g, 0, -1},
                           {g, 0, 1},
                           {-g, 0, -1},
                           {-g, 0, 1}}) {
    mesh.vertices.push_back(unit(v));
  }
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// From the centre to the plane that lies nearest.
double inner_radius(const bake::SourceMesh& sphere) {
  double least = 1;
  for (const auto& [a, b, c] : sphere.triangles) {
    const Vector3& p = sphere.vertices[a];
    const Vector3 u = sum(sphere.vertices[b], scaled(p, -1));
    const Vector3 v = sum(sphere.vertices[c], scaled(p, -1));
    const Vector3 normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                            u[0] * v[1] - u[1] * v[0]};
    least = std::min(least, dot(unit(normal), p));
  }
  return least;
}

/// A box in slices of equal length along an axis.
PrimitiveMesh sliced_box(const Vector3& size, std::size_t along, std::uint32_t slices) {
  const std::size_t j = (along + 1) % 3;
  const std::size_t k = (along + 2) % 3;
  PrimitiveMesh box;
  auto& vertices = box.mesh.vertices;
  auto& triangles = box.mesh.triangles;
  const auto add_quad = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
    triangles.push_back({p, q, r});
    triangles.push_back({p, r, s});
  };
  for (std::uint32_t slice = 0; slice <= slices; ++slice) {
    for (const auto& [y, z] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      Vector3 vertex;
      vertex[along] = (static_cast<double>(slice) / slices - 0.5) * size[along];
      vertex[j] = y * size[j];
      vertex[k] = z * size[k];
      vertices.push_back(vertex);
    }
  }
  for (std::uint32_t low = 0; low < 4 * slices; low += 4) {
    for (std::uint32_t side = 0; side < 4; ++side) {
      const std::uint32_t next = (side + 1) % 4;
      add_quad(low + side, low + next, low + 4 + next, low + 4 + side);
    }
  }
  add_quad(0, 3, 2, 1);
  add_quad(4 * slices, 4 * slices + 1, 4 * slices + 2, 4 * slices + 3);
  return box;
}

}  // namespace

void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings) {
  const std::string place = at_element(urdf, "link", link.name);
  for (const UrdfCollision& collision : link.collisions) {
    const UrdfGeometry& shape = collision.geometry;
    const Element element = shape.shape == UrdfGeometry::Shape::mesh
                                ? mesh_element(shape, urdf, packages, place, warnings)
                            : shape.shape == UrdfGeometry::Shape::triangles
                                ? Element{shape.triangles, shape.mesh, shape.precision}
                                : primitive_element(shape, place);
    append(element, composed(to_joint, collision.origin), place, made);
  }
}

/// Of the two triangles of a bar's long side the boxes are as large as whatever the bar is part of:
/// the longest axis is cut into slices about twice as long as they are thick.
PrimitiveMesh box_mesh(const Vector3& size) {
  constexpr double kMostSlices = 16;
  const auto along =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  const double thickness = std::max(size[(along + 1) % 3], size[(along + 2) % 3]);
  const double slices = std::min(size[along] / thickness / 2, kMostSlices);
  if (slices >= 2) {
    return sliced_box(size, along, static_cast<std::uint32_t>(slices));
  }
  PrimitiveMesh box;
  for (unsigned i = 0; i < 8; ++i) {
    box.mesh.vertices.push_back({(i & 1 ? 0.5 : -0.5) * size[0], (i & 2 ? 0.5 : -0.5) * size[1],
                                 (i & 4 ? 0.5 : -0.5) * size[2]});
  }
  box.mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                        {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

PrimitiveMesh cylinder_mesh(double radius, double length) {
  constexpr std::uint32_t kSides = 32;
  const double outer = radius / std::cos(kPi / kSides) * kRoundingMargin;
  PrimitiveMesh cylinder;
  cylinder.excess = outer - radius;
  auto& [vertices, triangles] = cylinder.mesh;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * kPi * i / kSides;
    for (const double z : {-0.5 * length, 0.5 * length}) {
      vertices.push_back({outer * std::cos(angle), outer * std::sin(angle), z});
    }
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t low = 2 * i;
    const std::uint32_t next = 2 * ((i + 1) % kSides);
    triangles.push_back({low, next, next + 1});
    triangles.push_back({low, next + 1, low + 1});
    if (i != 0 && i + 1 != kSides) {
      triangles.push_back({0, next, low});
      triangles.push_back({1, low + 1, next + 1});
    }
  }
  return cylinder;
}

/// Rings of corners about z, each end a corner. The half circles of the outline have a regular
/// polygon about them, each ring has one about its circle.
PrimitiveMesh capsule_mesh(double radius, double length) {
  constexpr std::uint32_t kSides = 24;
  constexpr std::uint32_t kRings = 10;  // half of them about either end
  const double end = radius / std::cos(kPi / (2 * kRings)) * kRoundingMargin;
  const double outer = end / std::cos(kPi / kSides) * kRoundingMargin;
  PrimitiveMesh capsule;
  capsule.excess = outer - radius;
  auto& [vertices, triangles] = capsule.mesh;
  vertices.push_back({0, 0, -0.5 * length - end});
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    const bool is_low = ring < kRings / 2;
    const double latitude = kPi * (ring + (is_low ? 1 : 0)) / kRings - kPi / 2;
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double angle = 2 * kPi * side / kSides;
      vertices.push_back({outer * std::cos(latitude) * std::cos(angle),
                          outer * std::cos(latitude) * std::sin(angle),
                          (is_low ? -0.5 : 0.5) * length + end * std::sin(latitude)});
    }
  }
  const auto last = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back({0, 0, 0.5 * length + end});
  for (std::uint32_t side = 0; side < kSides; ++side) {
    const std::uint32_t next = (side + 1) % kSides;
    triangles.push_back({0, 1 + next, 1 + side});
    triangles.push_back({last, last - kSides + side, last - kSides + next});
    for (std::uint32_t low = 1; low + kSides < last; low += kSides) {
      triangles.push_back({low + side, low + next, low + kSides + next});
      triangles.push_back({low + side, low + kSides + next, low + kSides + side});
    }
  }
  return capsule;
}

PrimitiveMesh ellipsoid_mesh(const Vector3& size) {
  PrimitiveMesh ellipsoid = sphere_mesh(0.5);
  ellipsoid.excess *= *std::max_element(size.begin(), size.end());
  for (Vector3& vertex : ellipsoid.mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] *= size[i];
    }
  }
  return ellipsoid;
}

PrimitiveMesh sphere_mesh(double radius) {
  PrimitiveMesh sphere = {icosahedron(), 0};
  cut(sphere.mesh);
  cut(sphere.mesh);
  const double outer = radius / inner_radius(sphere.mesh) * kRoundingMargin;
  sphere.excess = outer - radius;
  for (Vector3& vertex : sphere.mesh.vertices) {
    vertex = scaled(vertex, outer);
  }
  return sphere;
}

}  // namespace flashbvh::tool
