#include "robot/matrix/zone_side.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "bake/length.hpp"
#include "bake/surface.hpp"
#include "robot/kinematics.hpp"

namespace flashbvh::tool {
namespace {

/// Cutting ends at this number of triangles: firmware gets parts of them, and its 16-bit indices
/// reach 65,535 triangles and vertices.
constexpr std::size_t kMostTriangles = 24'000;

double length(const Vector3& p, const Vector3& q) {
  return bake::length(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// The file or primitive that each of a link's triangles comes from.
std::vector<std::uint32_t> sources_of(const ModelLink& link) {
  std::vector<std::uint32_t> sources(link.mesh.triangles.size());
  for (std::size_t i = 1; i < link.source_begins.size(); ++i) {
    std::fill(sources.begin() + static_cast<std::ptrdiff_t>(link.source_begins[i]), sources.end(),
              static_cast<std::uint32_t>(i));
  }
  return sources;
}

/// Halves triangles across their longest edges. Triangles that share an edge share its middle.
class Cutter {
 public:
  Cutter(bake::SourceMesh& mesh, std::vector<std::uint32_t>& shells,
         std::vector<std::uint32_t>& origins)
      : mesh_(mesh), shells_(shells), origins_(origins) {}

  template <class Reaches>
  void cut(std::uint32_t triangle, double edge, const Reaches& reaches_into) {
    std::vector<std::uint32_t> waiting = {triangle};
    while (!waiting.empty() && mesh_.triangles.size() < kMostTriangles) {
      const std::uint32_t number = waiting.back();
      waiting.pop_back();
      const std::size_t longest = longest_edge(number);
      if (length(corner(number, longest), corner(number, longest + 1)) > edge &&
          reaches_into(number)) {
        halve(number, longest);
        waiting.push_back(number);
        waiting.push_back(static_cast<std::uint32_t>(mesh_.triangles.size() - 1));
      }
    }
  }

 private:
  const Vector3& corner(std::uint32_t triangle, std::size_t i) const {
    return mesh_.vertices[mesh_.triangles[triangle][i % 3]];
  }

  std::size_t longest_edge(std::uint32_t triangle) const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (length(corner(triangle, i), corner(triangle, i + 1)) >
          length(corner(triangle, longest), corner(triangle, longest + 1))) {
        longest = i;
      }
    }
    return longest;
  }

  void halve(std::uint32_t triangle, std::size_t edge) {
    const bake::TriangleCorners whole = mesh_.triangles[triangle];
    const std::uint32_t middle = middle_of(whole[edge], whole[(edge + 1) % 3]);
    mesh_.triangles[triangle][(edge + 1) % 3] = middle;
    bake::TriangleCorners other = whole;
    other[edge] = middle;
    mesh_.triangles.push_back(other);
    shells_.push_back(shells_[triangle]);
    origins_.push_back(origins_[triangle]);
  }

  std::uint32_t middle_of(std::uint32_t p, std::uint32_t q) {
    const auto [place, is_new] =
        middles_.try_emplace(std::minmax(p, q), static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      Vector3 middle{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = 0.5 * (mesh_.vertices[p][axis] + mesh_.vertices[q][axis]);
      }
      mesh_.vertices.push_back(middle);
    }
    return place->second;
  }

  bake::SourceMesh& mesh_;
  std::vector<std::uint32_t>& shells_;
  std::vector<std::uint32_t>& origins_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

double ZoneShape::distance_of(const Vector3& point) const {
  return bake::length(point[0] - middle[0], point[1] - middle[1],
                      is_cylinder ? 0 : point[2] - middle[2]);
}

ZoneSide::ZoneSide(const ModelLink& link, const Transform& frame)
    : mesh_(link.mesh),
      to_joint_(inverse(frame)),
      origins_(link.mesh.triangles.size()),
      whole_(link.mesh.triangles) {
  std::iota(origins_.begin(), origins_.end(), 0);
  number_shells(link);
}

void ZoneSide::number_shells(const ModelLink& link) {
  const std::vector<std::uint32_t> sources = sources_of(link);
  const std::size_t count = mesh_.triangles.size();
  bake::Shells shells(count);
  std::map<std::tuple<std::uint32_t, double, double, double>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::uint32_t corner : mesh_.triangles[i]) {
      const auto& [x, y, z] = mesh_.vertices[corner];
      const auto place = first.try_emplace({sources[i], x, y, z}, i).first;
      shells.join(i, place->second);
    }
  }
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(numbers.size());
    shells_.push_back(numbers.try_emplace(shells.first_of(i), number).first->second);
  }
  shell_count_ = static_cast<std::uint32_t>(numbers.size());
}

Vector3 ZoneSide::corner(std::uint32_t triangle, std::size_t i) const {
  return placed(to_joint_, mesh_.vertices[mesh_.triangles[triangle][i]]);
}

void ZoneSide::cut(const std::vector<bool>& shells, const ZoneShape& shape, double edge) {
  // The middle of a triangle is no farther from any of its points than its longest edge.
  const auto reaches_into = [&](std::uint32_t triangle) {
    Vector3 middle{};
    double longest = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 at = corner(triangle, i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] += at[axis] / 3;
      }
      longest = std::max(longest, length(at, corner(triangle, (i + 1) % 3)));
      farthest = std::max(farthest, shape.distance_of(at));
    }
    return shape.distance_of(middle) - longest < shape.radius && farthest > shape.radius / 2;
  };
  Cutter cutter(mesh_, shells_, origins_);
  const std::size_t count = mesh_.triangles.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (shells[shells_[i]]) {
      cutter.cut(i, edge, reaches_into);
    }
  }
}

bake::SourceMesh ZoneSide::part(const std::vector<std::uint32_t>& triangles) const {
  std::vector<std::uint32_t> missing(whole_.size());
  for (const std::uint32_t origin : origins_) {
    ++missing[origin];
  }
  for (const std::uint32_t triangle : triangles) {
    --missing[origins_[triangle]];
  }
  std::vector<bool> is_taken(whole_.size());
  bake::SourceMesh part;
  part.vertices = mesh_.vertices;
  std::vector<std::uint32_t> all;
  for (const std::uint32_t triangle : triangles) {
    const std::uint32_t origin = origins_[triangle];
    if (!is_taken[origin]) {
      is_taken[origin] = missing[origin] == 0;
      part.triangles.push_back(is_taken[origin] ? whole_[origin] : mesh_.triangles[triangle]);
      all.push_back(static_cast<std::uint32_t>(all.size()));
    }
  }
  return part_of(part, all);
}

std::vector<double> ZoneSide::farthest(const ZoneShape& shape) const {
  std::vector<double> of;
  for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, shape.distance_of(corner(i, k)));
    }
    of.push_back(most);
  }
  return of;
}

}  // namespace flashbvh::tool
