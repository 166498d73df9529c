#include "bake/quantise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "flashbvh/image.hpp"

namespace flashbvh::bake {
namespace {

constexpr double kMaxWidth = 2.0 * kMaxCoordinate;

/// The nearest multiple of the cell, in cells; halves away from zero. The factor makes up for the
/// rounding of the coordinate, the cell and their quotient, half a unit in the last place each. So
/// a mesh in another unit is the same on its lattice.
double nearest(double coordinate, double cell) {
  return std::round(coordinate / cell * (1 + 0x1p-51));
}

struct Range {
  double low;
  double high;
};

/// The ends of the rounded mesh along an axis, in cells.
Range rounded_range(const Extent& extent, std::size_t axis, double cell) {
  return {nearest(extent.low[axis], cell), nearest(extent.high[axis], cell)};
}

/// The cell with which no axis of the mesh is over `width` cells wide or reaches further than
/// `origin`, before rounding.
double cell_of(const Extent& extent, double width, double origin) {
  auto cell = static_cast<double>(std::numeric_limits<float>::min());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = extent.low[axis];
    const double high = extent.high[axis];
    cell =
        std::max({cell, (high - low) / width, std::fabs(low) / origin, std::fabs(high) / origin});
  }
  return cell;
}

/// An upper bound of the distance of a point from its lattice point.
double distance_off(const std::array<double, 3>& point, double cell) {
  constexpr double rounding = 1 + 0x1p-50;  // of a sum of squares and its root
  double squared = 0;
  double sum = 0;
  double longest = 0;
  for (const double coordinate : point) {
    const double off = std::fabs(std::fma(-nearest(coordinate, cell), cell, coordinate));
    squared += off * off;
    sum += off;
    longest = std::max(longest, off);
  }
  return sum == longest ? longest : std::sqrt(squared) * rounding;
}

}  // namespace

std::array<double, 3> Extent::size() const {
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size[axis] = std::max(high[axis] - low[axis], 0.0);
  }
  return size;
}

Extent extent_of(const SourceMesh& mesh) {
  constexpr double most = std::numeric_limits<double>::infinity();
  Extent extent = {{most, most, most}, {-most, -most, -most}};
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      extent.low[axis] = std::min(extent.low[axis], vertex[axis]);
      extent.high[axis] = std::max(extent.high[axis], vertex[axis]);
    }
  }
  return extent;
}

bool fits(const Extent& extent, double cell) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = rounded_range(extent, axis, cell);
    if (!(high - low <= kMaxWidth) || !(std::fabs(low) <= kMaxOrigin) ||
        !(std::fabs(high) <= kMaxOrigin)) {
      return false;
    }
  }
  return true;
}

double finest_cell(const Extent& extent) {
  const double full = cell_of(extent, kMaxWidth, kMaxOrigin);
  // If the ends of the mesh lie halfway between cells, rounding widens it by one cell; a slightly
  // larger cell keeps the ends off the halves.
  for (const double cell : {full, full * (1 + 0x1p-48)}) {
    if (fits(extent, cell)) {
      return cell;
    }
  }
  return cell_of(extent, kMaxWidth - 1, kMaxOrigin - 1);
}

float float_above(double length) {
  constexpr float most = std::numeric_limits<float>::max();
  if (length > static_cast<double>(most) && std::isfinite(length)) {
    return most;
  }
  const auto near = static_cast<float>(length);
  return static_cast<double>(near) < length
             ? std::nextafter(near, std::numeric_limits<float>::infinity())
             : near;
}

double parts_above(double length, double cell, double parts) {
  const double count = std::ceil(length / cell * parts);
  return std::fma(count, cell, -parts * length) < 0 ? count + 1 : count;
}

std::uint16_t sixteenths_above(double deviation, double cell) {
  const double count = parts_above(static_cast<double>(float_above(deviation)), cell, 16);
  return count < kDeviationUnknown ? static_cast<std::uint16_t>(count) : kDeviationUnknown;
}

double deviation(const SourceMesh& mesh, double cell) {
  double most = 0;
  for (const auto& vertex : mesh.vertices) {
    most = std::max(most, distance_off(vertex, cell));
  }
  return most;
}

LatticeMesh round_to_lattice(const SourceMesh& mesh, const Extent& extent, double cell) {
  LatticeMesh rounded;
  rounded.cell = cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = rounded_range(extent, axis, cell);
    rounded.origin[axis] = static_cast<std::int32_t>(std::floor((low + high) / 2));
  }
  std::map<std::array<std::int16_t, 3>, std::uint32_t> joined;
  std::vector<std::uint32_t> index_of(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    std::array<std::int16_t, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] =
          static_cast<std::int16_t>(nearest(mesh.vertices[i][axis], cell) - rounded.origin[axis]);
    }
    const auto next = static_cast<std::uint32_t>(rounded.vertices.size());
    const auto [entry, inserted] = joined.emplace(at, next);
    if (inserted) {
      rounded.vertices.push_back({at[0], at[1], at[2]});
    }
    index_of[i] = entry->second;
    rounded.deviation = std::max(rounded.deviation, distance_off(mesh.vertices[i], cell));
  }
  for (const TriangleCorners& triangle : mesh.triangles) {
    rounded.triangles.push_back(
        {index_of[triangle[0]], index_of[triangle[1]], index_of[triangle[2]]});
  }
  return rounded;
}

}  // namespace flashbvh::bake
