#include "mesh/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/polygon.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

void MeshBuilder::begin_part(const Placement& placement) {
  first_ = points_.size();
  placement_ = placement;
}

void MeshBuilder::add_point(const Position& point) {
  points_.push_back(placement_ ? placed(point) : point);
}

Position MeshBuilder::placed(const Position& point) {
  Position placed{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& row = (*placement_)[axis];
    double size = 0;
    for (const double part : {row[0] * point[0], row[1] * point[1], row[2] * point[2], row[3]}) {
      placed[axis] += part;
      size += std::fabs(part);
    }
    if (!is_coordinate(size)) {
      throw UserError(file_,
                      "has a coordinate that is no finite number of at most 3.4e38; repair "
                      "the mesh");
    }
    largest_ = std::max(largest_, size);
  }
  return placed;
}

void MeshBuilder::add_polygon(const std::vector<std::uint32_t>& points) {
  std::vector<Position> corners;
  corners.reserve(points.size());
  for (const std::uint32_t point : points) {
    corners.push_back(points_[first_ + point]);
  }
  if (placement_ && is_mirrored(*placement_)) {
    std::reverse(corners.begin() + 1, corners.end());
  }
  for (const auto& [a, b, c] : triangulate(corners)) {
    add_triangle({corners[a], corners[b], corners[c]});
  }
}

void MeshBuilder::add_triangle(const std::array<Position, 3>& corners) {
  // Keeps the vertices, at most three per triangle, within 32-bit numbers.
  constexpr std::uint32_t kMost = 0xFFFFFFFF / 3;
  if (built_.mesh.triangles.size() == kMost) {
    throw UserError(file_, "has over ", kMost, " triangles; cut the mesh in parts");
  }
  built_.mesh.triangles.push_back(
      {vertex_at(corners[0]), vertex_at(corners[1]), vertex_at(corners[2])});
}

FileMesh MeshBuilder::finish() {
  if (built_.mesh.triangles.empty()) {
    throw UserError(file_, "has no polygons or triangles; export the mesh again");
  }
  if (left_out_ != 0) {
    built_.warnings.push_back(concat(left_out_, " points or lines left out"));
  }
  return std::move(built_);
}

std::uint32_t MeshBuilder::vertex_at(const Position& position) {
  const auto next = static_cast<std::uint32_t>(built_.mesh.vertices.size());
  const auto [entry, inserted] = vertex_at_.emplace(position, next);
  if (inserted) {
    built_.mesh.vertices.push_back(position);
  }
  return entry->second;
}

double coordinate(std::string_view word, const std::string& file, std::size_t line) {
  const auto value = parse_number(word);
  if (!value || !is_coordinate(*value)) {
    throw UserError(at_line(file, line), quoted(word),
                    " is no finite number of at most 3.4e38, which a coordinate must be; repair "
                    "the mesh");
  }
  return *value;
}

bool is_coordinate(double value) {
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

void warn_of_cut_line(std::string_view text, FileMesh& mesh) {
  if (text.back() != '\n' && text.back() != '\r') {
    mesh.warnings.emplace_back("the last line has no end: the file may be truncated");
  }
}

}  // namespace flashbvh::tool
