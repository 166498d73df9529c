#include "mesh/defects.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace flashbvh::tool {
namespace {

using bake::TriangleCorners;

/// True if a * b == c * d, exactly: compares each product as a sum of two numbers.
bool equal_products(double a, double b, double c, double d) {
  const double left = a * b;
  const double right = c * d;
  return left == right && std::fma(a, b, -left) == std::fma(c, d, -right);
}

bool are_parallel(const std::array<double, 3>& u, const std::array<double, 3>& v) {
  return equal_products(u[1], v[2], u[2], v[1]) && equal_products(u[2], v[0], u[0], v[2]) &&
         equal_products(u[0], v[1], u[1], v[0]);
}

std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

std::array<double, 3> difference(const Vertex& p, const Vertex& q) {
  return {1.0 * q.x - p.x, 1.0 * q.y - p.y, 1.0 * q.z - p.z};
}

/// Orders by `first`, then by `second`, in one comparison.
std::uint64_t key_of(std::uint32_t first, std::uint32_t second) {
  return std::uint64_t{first} << 32 | second;
}

/// An edge of one triangle.
struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  bool rises;  ///< the triangle runs from the lower vertex to the higher one

  bool operator<(const Edge& other) const {
    return key_of(low, high) < key_of(other.low, other.high);
  }
};

std::vector<Edge> edges_of(const std::vector<TriangleCorners>& triangles,
                           const TriangleIds& duplicates) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [p, q, r] = triangles[i];
    if (std::binary_search(duplicates.begin(), duplicates.end(), i) || p == q || q == r || r == p) {
      continue;
    }
    for (const auto& [from, to] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)}) {
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  return edges;
}

}  // namespace

template <class Mesh>
TriangleIds degenerate_triangles(const Mesh& mesh) {
  TriangleIds found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleCorners& corners = mesh.triangles[i];
    const auto& apex = mesh.vertices[corners[0]];
    if (are_parallel(difference(apex, mesh.vertices[corners[1]]),
                     difference(apex, mesh.vertices[corners[2]]))) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return found;
}

template TriangleIds degenerate_triangles(const bake::SourceMesh& mesh);
template TriangleIds degenerate_triangles(const bake::LatticeMesh& mesh);

TriangleIds duplicate_triangles(const std::vector<TriangleCorners>& triangles) {
  // Two corners; the third one and the triangle.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    TriangleCorners corners = triangles[i];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(key_of(corners[0], corners[1]),
                        key_of(corners[2], static_cast<std::uint32_t>(i)));
  }
  std::sort(sorted.begin(), sorted.end());
  TriangleIds found;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const auto& [corners, last] = sorted[i];
    if (corners == sorted[i - 1].first && last >> 32 == sorted[i - 1].second >> 32) {
      found.push_back(static_cast<std::uint32_t>(last));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<OddEdge> odd_edges(const std::vector<TriangleCorners>& triangles,
                               const TriangleIds& duplicates) {
  std::vector<Edge> edges = edges_of(triangles, duplicates);
  std::sort(edges.begin(), edges.end());
  std::vector<OddEdge> odd;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto end = std::upper_bound(first, edges.end(), *first);
    const auto count = end - first;
    if (count != 2 || first[0].rises == first[1].rises) {
      odd.push_back({{first->low, first->high},
                     count == 1   ? EdgeDefect::boundary
                     : count == 2 ? EdgeDefect::twisted
                                  : EdgeDefect::non_manifold});
    }
    first = end;
  }
  return odd;
}

EdgeDefects edge_defects(const std::vector<TriangleCorners>& triangles,
                         const TriangleIds& duplicates) {
  EdgeDefects defects;
  for (const OddEdge& edge : odd_edges(triangles, duplicates)) {
    defects.boundary += edge.defect == EdgeDefect::boundary ? 1 : 0;
    defects.non_manifold += edge.defect == EdgeDefect::non_manifold ? 1 : 0;
    defects.twisted += edge.defect == EdgeDefect::twisted ? 1 : 0;
  }
  return defects;
}

MeshDefects surface_defects(const bake::LatticeMesh& mesh) {
  MeshDefects defects;
  defects.duplicates = duplicate_triangles(mesh.triangles);
  defects.edges = edge_defects(mesh.triangles, defects.duplicates);
  if (defects.edges.none()) {
    set_orientation(mesh, defects);
  }
  return defects;
}

MeshDefects defects_of(const bake::SourceMesh& mesh, const bake::LatticeMesh& rounded,
                       const TriangleIds& degenerate) {
  MeshDefects defects = surface_defects(rounded);
  defects.degenerate = degenerate;
  const TriangleIds flat = degenerate_triangles(rounded);
  std::set_difference(flat.begin(), flat.end(), degenerate.begin(), degenerate.end(),
                      std::back_inserter(defects.collapsed));
  defects.closed_before = !defects.edges.none() &&
                          edge_defects(mesh.triangles, duplicate_triangles(mesh.triangles)).none();
  return defects;
}

}  // namespace flashbvh::tool
