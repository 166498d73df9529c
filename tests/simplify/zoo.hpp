// Meshes to simplify.
#pragma once

#include <string>

#include "bake/quantise.hpp"
#include "simplify/nearest.hpp"
#include "support/surface.hpp"
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

/// A closed box with `parts` x `parts` quads per side; the sides share no vertices.
inline bake::SourceMesh box(const Point& low, const Point& size, std::uint32_t parts) {
  bake::SourceMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool is_far : {false, true}) {
      const auto at = [&](double u, double v) {
        Point point = low;
        point[axis] += is_far ? size[axis] : 0;
        point[(axis + 1) % 3] += size[(axis + 1) % 3] * (is_far ? u : v);
        point[(axis + 2) % 3] += size[(axis + 2) % 3] * (is_far ? v : u);
        return point;
      };
      append(grid(parts, parts, false, at), mesh);
    }
  }
  return mesh;
}

/// Boxes with sides from 20 down to 0.02, far from one another.
inline bake::SourceMesh many_shells() {
  bake::SourceMesh mesh;
  double x = 0;
  for (double side = 20; side > 0.01; side /= 2) {
    append(box({x, 0, 0}, {side, side, side}, 4), mesh);
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

inline double finest_cell_of(const bake::SourceMesh& mesh) {
  return bake::finest_cell(bake::extent_of(mesh));
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

}  // namespace flashbvh::test
