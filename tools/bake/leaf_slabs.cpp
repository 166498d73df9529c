#include "bake/leaf_slabs.hpp"

#include <algorithm>
#include <cstdlib>

#include "bake/length.hpp"
#include "flashbvh/detail/bounds/slab.hpp"

namespace flashbvh::bake {
namespace {

using Triangles = std::vector<std::uint32_t>;

std::int64_t dot(const Point& u, const Point& v) {
  return std::int64_t{u.x} * v.x + std::int64_t{u.y} * v.y + std::int64_t{u.z} * v.z;
}

/// The range of a leaf's triangles along a direction.
struct Spread {
  std::int64_t least = INT64_MAX;
  std::int64_t most = INT64_MIN;
};

Spread spread_along(const LatticeMesh& mesh, const Triangles& triangles, const Point& d) {
  Spread spread;
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t vertex : mesh.triangles[triangle]) {
      const auto [x, y, z] = mesh.vertices[vertex];
      const std::int64_t along = dot(d, {x, y, z});
      spread = {std::min(spread.least, along), std::max(spread.most, along)};
    }
  }
  return spread;
}

/// That range's size, in 1/256 cell.
std::uint64_t thickness_of(const Spread& spread, const Point& d) {
  const auto length = static_cast<std::uint64_t>(dot(d, d));
  return (static_cast<std::uint64_t>(spread.most - spread.least) << 16) / square_root(length << 16);
}

struct Vector {
  std::int64_t x, y, z;
};

Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

std::int64_t largest(const Vector& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The vector with its largest component scaled to `most`, rounded; zeros for no vector.
Vector scaled(const Vector& v, std::int64_t most) {
  const std::int64_t size = largest(v);
  const auto part = [&](std::int64_t c) {
    const std::int64_t rounded = (2 * std::abs(c) * most + size) / (2 * size);
    return c < 0 ? -rounded : rounded;
  };
  return size == 0 ? v : Vector{part(v.x), part(v.y), part(v.z)};
}

/// The thinnest slab of some directions.
struct Thinnest {
  const LatticeMesh& mesh;
  const Triangles& triangles;
  Vector of{0, 0, 0};  ///< as considered
  Point direction{};   ///< rounded
  std::uint64_t thickness = UINT64_MAX;

  void consider(const Vector& along) {
    const Vector d = scaled(along, INT8_MAX);
    if (largest(d) == 0) {
      return;
    }
    const Point rounded = {static_cast<std::int32_t>(d.x), static_cast<std::int32_t>(d.y),
                           static_cast<std::int32_t>(d.z)};
    const std::uint64_t now = thickness_of(spread_along(mesh, triangles, rounded), rounded);
    if (now < thickness) {
      of = along;
      direction = rounded;
      thickness = now;
    }
  }
};

/// The shortest code of at least this thickness.
std::uint8_t thickness_code(std::int64_t thickness) {
  unsigned exponent = 0;
  while (thickness > 31) {
    thickness = (thickness + 3) / 4;
    ++exponent;
  }
  return static_cast<std::uint8_t>(exponent << 5 | static_cast<unsigned>(thickness));
}

void put(const Thinnest& from, int which, LeafSlabs& slabs) {
  const auto [least, most] = spread_along(from.mesh, from.triangles, from.direction);
  constexpr std::int64_t unit = 1 << (kSlabUnitBits - (detail::kDirectionBits - 7));
  const std::int64_t from_unit = least >= 0 ? least / unit : -((unit - 1 - least) / unit);
  slabs.least[which] = static_cast<std::int16_t>(from_unit);
  slabs.of[which] = {static_cast<std::int8_t>(from.direction.x),
                     static_cast<std::int8_t>(from.direction.y),
                     static_cast<std::int8_t>(from.direction.z),
                     thickness_code((most - from_unit * unit + unit - 1) / unit)};
}

}  // namespace

LeafSlabs leaf_slabs(const LatticeMesh& mesh, const Triangles& triangles) {
  const auto edge = [&](std::uint32_t triangle, std::size_t i) {
    const TriangleCorners& corners = mesh.triangles[triangle];
    const Vertex& p = mesh.vertices[corners[i]];
    const Vertex& q = mesh.vertices[corners[(i + 1) % 3]];
    return Vector{q.x - p.x, q.y - p.y, q.z - p.z};
  };
  Thinnest plane{mesh, triangles};
  Vector sum = {0, 0, 0};
  for (const std::uint32_t triangle : triangles) {
    const Vector normal = cross(edge(triangle, 0), edge(triangle, 1));
    plane.consider(normal);
    sum = {sum.x + normal.x, sum.y + normal.y, sum.z + normal.z};
  }
  plane.consider(sum);
  LeafSlabs slabs{};
  if (plane.thickness == UINT64_MAX) {
    return slabs;
  }
  Thinnest across{mesh, triangles};
  const Vector normal = scaled(plane.of, 1 << 13);
  for (const std::uint32_t triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      across.consider(cross(edge(triangle, i), normal));
    }
  }
  put(plane, 0, slabs);
  if (across.thickness != UINT64_MAX) {
    put(across, 1, slabs);
  }
  return slabs;
}

}  // namespace flashbvh::bake
