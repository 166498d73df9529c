#include "robot/revolution.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::tool {
namespace {

constexpr std::uint32_t kSlabs = 16;
constexpr std::uint32_t kSides = 32;
/// Widths that differ by less than this part are the same.
constexpr double kAlike = 0.02;
constexpr double kHalfTurn = 3.141592653589793;

/// The largest distance from z of a segment's part between two heights; 0 if there is none.
/// Distance from a line is convex: it is largest at an end.
double widest(const Vector3& p, const Vector3& q, double low, double high) {
  const double rise = q[2] - p[2];
  double from = 0;
  double to = 1;
  if (rise != 0) {
    const double one = (low - p[2]) / rise;
    const double other = (high - p[2]) / rise;
    from = std::max(0.0, std::min(one, other));
    to = std::min(1.0, std::max(one, other));
  } else if (p[2] < low || p[2] > high) {
    return 0;
  }
  if (from > to) {
    return 0;
  }
  const auto at = [&](double part) {
    return std::hypot(p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]));
  };
  return std::max(at(from), at(to));
}

/// Of all triangles: what of one lies between two heights has its corners on its edges.
double widest(const bake::SourceMesh& mesh, double low, double high) {
  double most = 0;
  for (const bake::TriangleCorners& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      most = std::max(most, widest(mesh.vertices[triangle[i]], mesh.vertices[triangle[(i + 1) % 3]],
                                   low, high));
    }
  }
  return most;
}

/// A part of the axis and how wide the body is there.
struct Slab {
  double low;
  double high;
  double radius;
};

std::vector<Slab> slabs_of(const bake::SourceMesh& mesh, double low, double high, double margin) {
  std::vector<Slab> slabs;
  for (std::uint32_t i = 0; i < kSlabs; ++i) {
    const double from = low + (high - low) * i / kSlabs;
    const double to = low + (high - low) * (i + 1) / kSlabs;
    slabs.push_back({from, to, widest(mesh, from - margin, to + margin) + margin});
  }
  return slabs;
}

/// Neighbours of nearly the same width as one: fewer triangles.
std::vector<Slab> merged(const std::vector<Slab>& slabs) {
  std::vector<Slab> kept;
  for (const Slab& slab : slabs) {
    if (!kept.empty() && std::fabs(kept.back().radius - slab.radius) < kAlike * slab.radius) {
      kept.back() = {kept.back().low, slab.high, std::max(kept.back().radius, slab.radius)};
    } else {
      kept.push_back(slab);
    }
  }
  return kept;
}

void add_ring(bake::SourceMesh& mesh, double radius, double z) {
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * kHalfTurn * i / kSides;
    mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
}

/// Sides between one ring and the next, and the lids; the vertices are all there, the middles of
/// the lids last.
void add_triangles(bake::SourceMesh& mesh) {
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size() - 2);
  const std::uint32_t last = bottom - kSides;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t next = (i + 1) % kSides;
    mesh.triangles.push_back({bottom, next, i});
    mesh.triangles.push_back({bottom + 1, last + i, last + next});
    for (std::uint32_t ring = 0; ring < last; ring += kSides) {
      mesh.triangles.push_back({ring + i, ring + next, ring + kSides + next});
      mesh.triangles.push_back({ring + i, ring + kSides + next, ring + kSides + i});
    }
  }
}

}  // namespace

bake::SourceMesh revolved(const bake::SourceMesh& mesh, const Transform& axis, double margin) {
  bake::SourceMesh seen = mesh;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (Vector3& vertex : seen.vertices) {
    vertex = placed(inverse(axis), vertex);
    low = std::min(low, vertex[2]);
    high = std::max(high, vertex[2]);
  }
  low -= margin;
  high += margin;
  bake::SourceMesh body;
  for (const Slab& slab : merged(slabs_of(seen, low, high, margin))) {
    add_ring(body, slab.radius / std::cos(kHalfTurn / kSides), slab.low);
    add_ring(body, slab.radius / std::cos(kHalfTurn / kSides), slab.high);
  }
  body.vertices.push_back({0, 0, low});
  body.vertices.push_back({0, 0, high});
  add_triangles(body);
  for (Vector3& vertex : body.vertices) {
    vertex = placed(axis, vertex);
  }
  return body;
}

}  // namespace flashbvh::tool
