// Primitives as closed meshes, triangles counter-clockwise from outside. A round shape lies inside
// its mesh: an object that hits the shape hits the mesh.
#pragma once

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::tool {

struct PrimitiveMesh {
  bake::SourceMesh mesh;
  double excess = 0;  ///< bound on how far the mesh reaches beyond the shape
};

// Centred in their frames; lengths are positive, in one unit.

/// 12 triangles; a long bar has up to 132.
PrimitiveMesh box_mesh(const Vector3& size);
/// Along z. A prism with 32 sides, 124 triangles: 0.5 % wider.
PrimitiveMesh cylinder_mesh(double radius, double length);
/// An icosahedron cut twice, 320 triangles: 1.9 % wider.
PrimitiveMesh sphere_mesh(double radius);

/// Adds the triangles of a closed surface round z. Its vertices exist: the lowest point, rings of
/// `sides` vertices, the lowest first, and the highest point.
void add_round_triangles(bake::SourceMesh& mesh, std::uint32_t sides);

}  // namespace flashbvh::tool
