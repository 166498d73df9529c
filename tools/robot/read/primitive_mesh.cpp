#include "robot/read/primitive_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "simplify/nearest.hpp"

namespace flashbvh::tool {
namespace {

/// More than a radius loses by the rounding of coordinates.
constexpr double kRoundingMargin = 1 + 0x1p-48;

Vector3 scaled(const Vector3& v, double factor) {
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}
Vector3 sum(const Vector3& v, const Vector3& w) {
  return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}
Vector3 unit(const Vector3& v) {
  return scaled(v, 1 / std::sqrt(simplify::dot(v, v)));
}

/// Divides each triangle into four, with all corners on the unit sphere.
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
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vector3& vertex : mesh.vertices) {
    vertex = unit(vertex);
  }
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// The distance from the centre to the nearest plane of a triangle.
double inner_radius(const bake::SourceMesh& sphere) {
  double least = 1;
  for (const auto& [a, b, c] : sphere.triangles) {
    const Vector3& p = sphere.vertices[a];
    const Vector3 normal = simplify::cross(simplify::minus(sphere.vertices[b], p),
                                           simplify::minus(sphere.vertices[c], p));
    least = std::min(least, simplify::dot(unit(normal), p));
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

/// Two triangles along a bar's side would have boxes as large as the mesh that the bar is part of.
/// So the longest axis is cut into slices about twice as long as they are thick.
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

void add_round_triangles(bake::SourceMesh& mesh, std::uint32_t sides) {
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (std::uint32_t side = 0; side < sides; ++side) {
    const std::uint32_t next = (side + 1) % sides;
    mesh.triangles.push_back({0, 1 + next, 1 + side});
    mesh.triangles.push_back({last, last - sides + side, last - sides + next});
    for (std::uint32_t low = 1; low + sides < last; low += sides) {
      mesh.triangles.push_back({low + side, low + next, low + sides + next});
      mesh.triangles.push_back({low + side, low + sides + next, low + sides + side});
    }
  }
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
