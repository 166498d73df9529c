#include "robot/read/link_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/import.hpp"
#include "robot/kinematics.hpp"
#include "robot/read/primitives.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

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

Element primitive_element(const UrdfGeometry& shape, const std::string& place) {
  if (shape.shape == UrdfGeometry::Shape::box) {
    for (const double edge : shape.size) {
      check_positive(edge, "a box with an edge", place);
    }
    return {box_mesh(shape.size).mesh, "box", 0};
  }
  check_positive(shape.radius, "a radius", place);
  const bool is_sphere = shape.shape == UrdfGeometry::Shape::sphere;
  if (!is_sphere) {
    check_positive(shape.length, "a cylinder's length", place);
  }
  PrimitiveMesh round =
      is_sphere ? sphere_mesh(shape.radius) : cylinder_mesh(shape.radius, shape.length);
  return {std::move(round.mesh),
          concat(is_sphere ? "sphere" : "cylinder", " of radius ", shortest(shape.radius),
                 " m, up to ", significant(round.excess, 2), " m wider"),
          0};
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

}  // namespace

void add_link_mesh(const UrdfLink& link, const Transform& to_joint, const std::string& urdf,
                   const Packages& packages, ModelLink& made, Warnings& warnings) {
  const std::string place = at_element(urdf, "link", link.name);
  for (const UrdfCollision& collision : link.collisions) {
    const UrdfGeometry& shape = collision.geometry;
    const Element element = shape.shape == UrdfGeometry::Shape::mesh
                                ? mesh_element(shape, urdf, packages, place, warnings)
                                : primitive_element(shape, place);
    append(element, composed(to_joint, collision.origin), place, made);
  }
}

}  // namespace flashbvh::tool
