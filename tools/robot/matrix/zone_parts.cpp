// The parts of two neighbours outside their zone that a guard tests.
#include <algorithm>
#include <numeric>

#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"

namespace flashbvh::tool {
namespace {

/// Joint boxes for the search whether a part of a link ever comes near the other link.
constexpr std::uint64_t kCellsOfPart = 400;
/// So few triangles are no longer divided.
constexpr std::size_t kFewTriangles = 4;

/// Finds the triangles of one side that may come near the other. When time is up, keeps the rest.
class Sieve {
 public:
  Sieve(const Model& model, const JointZone& zone, bool of_a, double cell,
        const MatrixOptions& options)
      : model_(model),
        zone_(zone),
        of_a_(of_a),
        cell_(cell),
        options_(options),
        stop_(options.of(zone.a, zone.b).stop) {
    options_.most_joint_boxes = kCellsOfPart;
    options_.slack += 2 * kDeviation;  // vertices at cuts are rounded again
  }

  bake::SourceMesh near(const bake::SourceMesh& mesh, const WholeMesh& other) const {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<std::uint32_t> kept;
    look_at(mesh, other, all, kept);
    std::sort(kept.begin(), kept.end());
    return part_of(mesh, kept);
  }

 private:
  bool may_come_near(const bake::SourceMesh& part, const WholeMesh& other) const {
    const BakedPart baked = bake_part(part, cell_);
    const PairSpace space(model_, {zone_.a, of_a_ ? baked.view() : other},
                          {zone_.b, of_a_ ? other : baked.view()}, cell_);
    return search_pair(space, options_, stop_).end != SearchEnd::apart;
  }

  void look_at(const bake::SourceMesh& mesh, const WholeMesh& other,
               const std::vector<std::uint32_t>& triangles,
               std::vector<std::uint32_t>& kept) const {
    if (triangles.empty()) {
      return;
    }
    const bool is_late = options_.is_late();
    if (!is_late && !may_come_near(part_of(mesh, triangles), other)) {
      return;
    }
    if (is_late || triangles.size() <= kFewTriangles) {
      kept.insert(kept.end(), triangles.begin(), triangles.end());
      return;
    }
    const auto [lower, upper] = halves(mesh, triangles);
    look_at(mesh, other, lower, kept);
    look_at(mesh, other, upper, kept);
  }

  /// Halves by position along the axis in which the triangles lie farthest apart.
  static std::array<std::vector<std::uint32_t>, 2> halves(const bake::SourceMesh& mesh,
                                                          std::vector<std::uint32_t> triangles) {
    const auto centre = [&](std::uint32_t triangle) {
      return simplify::centre_of(simplify::triangle_of(mesh, mesh.triangles[triangle]));
    };
    simplify::Box box;
    for (const std::uint32_t triangle : triangles) {
      box.add(centre(triangle));
    }
    const Vector3 size = simplify::minus(box.high, box.low);
    const auto longest = std::max_element(size.begin(), size.end()) - size.begin();
    std::sort(triangles.begin(), triangles.end(), [&](std::uint32_t p, std::uint32_t q) {
      return std::pair(centre(p)[longest], p) < std::pair(centre(q)[longest], q);
    });
    const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
    return {std::vector(triangles.begin(), middle), std::vector(middle, triangles.end())};
  }

  const Model& model_;
  const JointZone& zone_;
  bool of_a_;
  double cell_;
  MatrixOptions options_;
  double stop_;
};

}  // namespace

std::vector<ZoneParts> zone_parts(const Model& model, const JointZone& zone, double cell,
                                  const MatrixOptions& options) {
  const Sieve of_a(model, zone, true, cell, options);
  const Sieve of_b(model, zone, false, cell, options);
  std::vector<ZoneParts> all;
  for (const ZoneBodies& bodies : zone.bodies) {
    ZoneParts parts;
    parts.a = of_a.near(bodies.mesh_a, bodies.b.view());
    if (parts.a.triangles.empty()) {
      continue;
    }
    const BakedPart near_a = bake_part(parts.a, cell);
    parts.b = of_b.near(bodies.mesh_b, near_a.view());
    if (!parts.b.triangles.empty()) {
      all.push_back(std::move(parts));
    }
  }
  return all;
}

}  // namespace flashbvh::tool
