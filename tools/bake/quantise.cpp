#include "bake/quantise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "flashbvh/image.hpp"

namespace flashbvh::bake {
namespace {

constexpr double kMaxWidth = 2.0 * kMaxCoordinate;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range range_of(const SourceMesh& mesh, std::size_t axis) {
  Range range;
  for (const auto& vertex : mesh.vertices) {
    range.low = std::min(range.low, vertex[axis]);
    range.high = std::max(range.high, vertex[axis]);
  }
  return range;
}

/// The nearest multiple of the cell, in cells; halves away from zero. The factor makes up for the
/// rounding of the coordinate, the cell and their quotient, half a unit in the last place each. So
/// a mesh in another unit is the same on its lattice.
double nearest(double coordinate, double cell) {
  return std::round(coordinate / cell * (1 + 0x1p-51));
}

/// The lattice point in the middle of the rounded mesh.
std::int32_t middle(const Range& range, double cell) {
  const double low = nearest(range.low, cell);
  const double high = nearest(range.high, cell);
  return static_cast<std::int32_t>(std::floor((low + high) / 2));
}

/// The cell with which no axis of the mesh is over `width` cells wide or reaches further than
/// `origin`, before rounding.
double cell_of(const SourceMesh& mesh, double width, double origin) {
  double cell = std::numeric_limits<double>::min();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range range = range_of(mesh, axis);
    cell = std::max({cell, (range.high - range.low) / width, std::fabs(range.low) / origin,
                     std::fabs(range.high) / origin});
  }
  return cell;
}

}  // namespace

bool fits(const SourceMesh& mesh, double cell) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range range = range_of(mesh, axis);
    const double low = nearest(range.low, cell);
    const double high = nearest(range.high, cell);
    if (!(high - low <= kMaxWidth) || !(std::fabs(low) <= kMaxOrigin) ||
        !(std::fabs(high) <= kMaxOrigin)) {
      return false;
    }
  }
  return true;
}

double finest_cell(const SourceMesh& mesh) {
  const double full = cell_of(mesh, kMaxWidth, kMaxOrigin);
  // If the ends of the mesh lie halfway between cells, rounding widens it by one cell; a slightly
  // larger cell keeps the ends off the halves.
  for (const double cell : {full, full * (1 + 0x1p-48)}) {
    if (fits(mesh, cell)) {
      return cell;
    }
  }
  return cell_of(mesh, kMaxWidth - 1, kMaxOrigin - 1);
}

std::vector<std::uint32_t> out_of_range(const SourceMesh& mesh, double cell) {
  std::vector<bool> is_out(mesh.vertices.size(), false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range range = range_of(mesh, axis);
    const double origin = std::floor((nearest(range.low, cell) + nearest(range.high, cell)) / 2);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const double at = nearest(mesh.vertices[i][axis], cell);
      if (!(std::fabs(at - origin) <= kMaxCoordinate) || !(std::fabs(at) <= kMaxOrigin)) {
        is_out[i] = true;
      }
    }
  }
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleCorners& corners = mesh.triangles[i];
    if (is_out[corners[0]] || is_out[corners[1]] || is_out[corners[2]]) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return found;
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
  constexpr double rounding = 1 + 0x1p-50;  // of a sum of squares and its root
  double most = 0;
  for (const auto& vertex : mesh.vertices) {
    double squared = 0;
    double sum = 0;
    double longest = 0;
    for (const double coordinate : vertex) {
      const double off = std::fabs(std::fma(-nearest(coordinate, cell), cell, coordinate));
      squared += off * off;
      sum += off;
      longest = std::max(longest, off);
    }
    most = std::max(most, sum == longest ? longest : std::sqrt(squared) * rounding);
  }
  return most;
}

LatticeMesh round_to_lattice(const SourceMesh& mesh, double cell) {
  LatticeMesh rounded;
  rounded.cell = cell;
  rounded.deviation = deviation(mesh, cell);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rounded.origin[axis] = middle(range_of(mesh, axis), cell);
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
  }
  for (const TriangleCorners& triangle : mesh.triangles) {
    rounded.triangles.push_back(
        {index_of[triangle[0]], index_of[triangle[1]], index_of[triangle[2]]});
  }
  return rounded;
}

}  // namespace flashbvh::bake
