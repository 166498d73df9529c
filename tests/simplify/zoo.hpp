// Meshes to simplify, and samples of their surfaces.
#pragma once

#include <string>

#include "bake/mesh.hpp"
#include "simplify/nearest.hpp"
#include "support/test.hpp"

namespace flashbvh::test {

using simplify::Point;

/// A grid of `across` x `along` quads, closed around or open.
template <class At>
bake::SourceMesh grid(std::uint32_t across, std::uint32_t along, bool is_round, const At& at) {
  const std::uint32_t columns = is_round ? across : across + 1;
  const std::uint32_t rows = is_round ? along : along + 1;
  bake::SourceMesh mesh;
  for (std::uint32_t i = 0; i < columns; ++i) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      mesh.vertices.push_back(at(1.0 * i / across, 1.0 * j / along));
    }
  }
  const auto index = [&](std::uint32_t i, std::uint32_t j) {
    return i % columns * rows + j % rows;
  };
  for (std::uint32_t i = 0; i < across; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

constexpr double kTurn = 6.283185307179587;

/// A ring of radius 30, its tube of radius 10 with waves of `wave`.
inline bake::SourceMesh wavy_ring(std::uint32_t around, std::uint32_t across, double wave) {
  return grid(around, across, true, [&](double u, double v) -> Point {
    const double r = 30 + 10 * std::cos(kTurn * v) + wave * std::sin(7 * kTurn * u);
    return {r * std::cos(kTurn * u), r * std::sin(kTurn * u),
            10 * std::sin(kTurn * v) + wave * std::cos(5 * kTurn * u)};
  });
}

/// An open, hilly mesh of 100 x 60.
inline bake::SourceMesh hills(std::uint32_t across, std::uint32_t along) {
  return grid(across, along, false, [](double u, double v) -> Point {
    return {100 * u, 60 * v, 3 * std::sin(9 * u) * std::cos(7 * v)};
  });
}

/// A closed box with `parts` x `parts` quads per side and shared vertices.
inline bake::SourceMesh box(const Point& low, const Point& size, std::uint32_t parts) {
  bake::SourceMesh mesh;
  std::vector<std::uint32_t> index_of((parts + 1) * (parts + 1) * (parts + 1), UINT32_MAX);
  const auto vertex = [&](const std::array<std::uint32_t, 3>& at) {
    std::uint32_t& index = index_of[(at[0] * (parts + 1) + at[1]) * (parts + 1) + at[2]];
    if (index == UINT32_MAX) {
      index = static_cast<std::uint32_t>(mesh.vertices.size());
      Point point{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] = low[axis] + size[axis] * at[axis] / parts;
      }
      mesh.vertices.push_back(point);
    }
    return index;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool is_far : {false, true}) {
      for (std::uint32_t i = 0; i < parts; ++i) {
        for (std::uint32_t j = 0; j < parts; ++j) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            std::array<std::uint32_t, 3> at{};
            at[axis] = is_far ? parts : 0;
            at[(axis + 1) % 3] = i + (is_far ? di : dj);
            at[(axis + 2) % 3] = j + (is_far ? dj : di);
            return vertex(at);
          };
          mesh.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
          mesh.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
      }
    }
  }
  return mesh;
}

inline void add(const bake::SourceMesh& more, bake::SourceMesh& mesh) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const bake::TriangleCorners& corners : more.triangles) {
    mesh.triangles.push_back({corners[0] + base, corners[1] + base, corners[2] + base});
  }
}

/// Boxes with sides from 20 down to 0.02, far from one another.
inline bake::SourceMesh many_shells() {
  bake::SourceMesh mesh;
  double x = 0;
  for (double side = 20; side > 0.01; side /= 2) {
    add(box({x, 0, 0}, {side, side, side}, 4), mesh);
    x += 2 * side + 5;
  }
  return mesh;
}

/// Each triangle twice, and one in three a third time, reversed.
inline bake::SourceMesh repeated(const bake::SourceMesh& mesh) {
  bake::SourceMesh more = mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const bake::TriangleCorners& corners = mesh.triangles[i];
    more.triangles.push_back({corners[1], corners[2], corners[0]});
    if (i % 3 == 0) {
      more.triangles.push_back({corners[2], corners[1], corners[0]});
    }
  }
  return more;
}

/// Each triangle with its own vertices: nothing is connected until vertices are joined.
inline bake::SourceMesh loose(const bake::SourceMesh& mesh) {
  bake::SourceMesh apart;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    const auto base = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t corner : corners) {
      apart.vertices.push_back(mesh.vertices[corner]);
    }
    apart.triangles.push_back({base, base + 1, base + 2});
  }
  return apart;
}

struct Specimen {
  std::string name;
  bake::SourceMesh mesh;
  bool is_closed;
};

inline std::vector<Specimen> specimens() {
  return {{"a wavy ring", wavy_ring(50, 16, 0.4), true},
          {"hills, open", hills(30, 18), false},
          {"a thin sheet", box({0, 0, 0}, {80, 50, 0.2}, 8), true},
          {"shells of all sizes", many_shells(), true},
          {"repeated triangles", repeated(box({0, 0, 0}, {40, 30, 20}, 6)), false},
          {"a ring of loose triangles", loose(wavy_ring(40, 14, 0)), true},
          {"one triangle", {{{0, 0, 0}, {9, 0, 0}, {0, 9, 1}}, {{0, 1, 2}}}, false},
          {"a needle", {{{0, 0, 0}, {9, 0, 0}, {4, 0, 0}}, {{0, 1, 2}}}, false}};
}

/// A random point of a mesh; all triangles are equally likely.
inline Point sample(const bake::SourceMesh& mesh, Random& random) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  const bake::TriangleCorners& corners = mesh.triangles[random.below(count)];
  // Corners and edges matter most: a quarter of the samples each.
  double s = random.below(4) == 0 ? 0 : random.below(1001) / 1000.0;
  double t = random.below(4) == 0 ? 0 : random.below(1001) / 1000.0;
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  Point at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = mesh.vertices[corners[0]][axis] * (1 - s - t) + mesh.vertices[corners[1]][axis] * s +
               mesh.vertices[corners[2]][axis] * t;
  }
  return at;
}

/// The distance to a mesh by testing each triangle: the feet of perpendiculars, in long double.
/// Shares no code with the tested functions.
double distance_by_force(const Point& p, const bake::SourceMesh& mesh);

}  // namespace flashbvh::test
