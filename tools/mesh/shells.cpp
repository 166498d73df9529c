// Shells of a closed surface that are inside out. A cavity is inside out, too, and lies within
// another shell.
#include <algorithm>

#include "bake/surface.hpp"
#include "mesh/defects.hpp"

namespace flashbvh::tool {
namespace {

/// About the most points at which shells are compared with the others.
constexpr std::size_t kMostPoints = 3000;

using Point3 = std::array<double, 3>;

/// The triangles of each shell; each shell under the number of its first vertex, others empty.
std::vector<TriangleIds> triangles_of_shells(const bake::LatticeMesh& mesh,
                                             const TriangleIds& duplicates) {
  const std::vector<std::uint32_t> first = bake::shells_of(mesh.triangles, mesh.vertices.size());
  std::vector<TriangleIds> shells(mesh.vertices.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!std::binary_search(duplicates.begin(), duplicates.end(), i)) {
      shells[first[mesh.triangles[i][0]]].push_back(i);
    }
  }
  return shells;
}

Point3 corner_of(const bake::LatticeMesh& mesh, std::uint32_t triangle, std::size_t corner) {
  const Vertex& v = mesh.vertices[mesh.triangles[triangle][corner]];
  return {double(v.x), double(v.y), double(v.z)};
}

/// Twice the area of a triangle's projection along x.
double area_of(const Point3& p, const Point3& q, const Point3& r) {
  return (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
}

/// Six times the volume: sums tetrahedra with an apex at the lattice's zero, each below 2^45. Sums
/// may wrap.
std::uint64_t volume_of(const bake::LatticeMesh& mesh, const TriangleIds& shell) {
  std::uint64_t volume = 0;
  for (const std::uint32_t i : shell) {
    const Vertex& p = mesh.vertices[mesh.triangles[i][0]];
    const Vertex& q = mesh.vertices[mesh.triangles[i][1]];
    const Vertex& r = mesh.vertices[mesh.triangles[i][2]];
    const std::int64_t x = std::int64_t{q.y} * r.z - std::int64_t{q.z} * r.y;
    const std::int64_t y = std::int64_t{q.z} * r.x - std::int64_t{q.x} * r.z;
    const std::int64_t z = std::int64_t{q.x} * r.y - std::int64_t{q.y} * r.x;
    volume += static_cast<std::uint64_t>(p.x * x + p.y * y + p.z * z);
  }
  return volume;
}

bool is_negative(std::uint64_t volume) {
  return volume >> 63 != 0;
}

/// How often the triangles wind round a point, by a ray along x. The point is on no edge's
/// projection.
int winding_of(const bake::LatticeMesh& mesh, const TriangleIds& triangles, const Point3& point) {
  int winding = 0;
  for (const std::uint32_t i : triangles) {
    const Point3 corners[] = {corner_of(mesh, i, 0), corner_of(mesh, i, 1), corner_of(mesh, i, 2)};
    const auto [below, above] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
    if (point[1] < below || point[1] > above) {
      continue;
    }
    const double parts[] = {area_of(point, corners[1], corners[2]),
                            area_of(corners[0], point, corners[2]),
                            area_of(corners[0], corners[1], point)};
    const auto [least, most] = std::minmax({parts[0], parts[1], parts[2]});
    if (least <= 0 && most >= 0) {
      continue;
    }
    const double x =
        (parts[0] * corners[0][0] + parts[1] * corners[1][0] + parts[2] * corners[2][0]) /
        (parts[0] + parts[1] + parts[2]);
    winding += x < point[0] ? 0 : most > 0 ? 1 : -1;
  }
  return winding;
}

/// Points in the triangles of a shell near their corners, moved off the lattice.
std::vector<Point3> points_of(const bake::LatticeMesh& mesh, const TriangleIds& shell,
                              std::size_t most) {
  constexpr Point3 kOff = {0x1.3p-12, 0x1.7p-13, 0x1.9p-14};
  std::vector<Point3> points;
  const std::size_t step = 3 * shell.size() / most + 1;
  for (std::size_t i = 0; i < 3 * shell.size(); i += step) {
    const std::uint32_t triangle = shell[i / 3];
    Point3 point = corner_of(mesh, triangle, i % 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double middle = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        middle += corner_of(mesh, triangle, corner)[axis] / 3;
      }
      point[axis] += (middle - point[axis]) / 64 + kOff[axis];
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace

void set_orientation(const bake::LatticeMesh& mesh, MeshDefects& defects) {
  const std::vector<TriangleIds> shells = triangles_of_shells(mesh, defects.duplicates);
  std::vector<const TriangleIds*> inverted;
  std::uint64_t volume = 0;
  for (const TriangleIds& shell : shells) {
    const std::uint64_t of_shell = volume_of(mesh, shell);
    volume += of_shell;
    if (is_negative(of_shell)) {
      inverted.push_back(&shell);
    }
  }
  defects.inside_out = is_negative(volume);
  for (const TriangleIds* const shell : inverted) {
    TriangleIds others;
    for (const TriangleIds& other : shells) {
      if (&other != shell) {
        others.insert(others.end(), other.begin(), other.end());
      }
    }
    const std::vector<Point3> points = points_of(mesh, *shell, kMostPoints / inverted.size() + 6);
    const auto is_outside = [&](const Point3& point) {
      return winding_of(mesh, others, point) <= 0;
    };
    defects.shells_inside_out += std::any_of(points.begin(), points.end(), is_outside) ? 1 : 0;
  }
}

}  // namespace flashbvh::tool
