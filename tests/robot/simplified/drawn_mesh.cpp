#include "drawn_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::test {
namespace {

constexpr std::uint32_t kLeafSize = 2;

Vector3 minus(const Vector3& p, const Vector3& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

double dot(const Vector3& p, const Vector3& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Vector3 cross(const Vector3& p, const Vector3& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Vector3 along(const Vector3& p, const Vector3& step, double by) {
  return {p[0] + by * step[0], p[1] + by * step[1], p[2] + by * step[2]};
}

double squared_apart(const Vector3& p, const Vector3& q) {
  return dot(minus(p, q), minus(p, q));
}

/// The squared distance of two segments: of their lines' nearest points, each clamped to its
/// segment, and of each end.
double squared_edges(const Vector3& p, const Vector3& p_end, const Vector3& q,
                     const Vector3& q_end) {
  const Vector3 u = minus(p_end, p);
  const Vector3 v = minus(q_end, q);
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const auto on_p = [&](const Vector3& x) {
    return along(p, u, uu > 0 ? std::clamp(dot(minus(x, p), u) / uu, 0.0, 1.0) : 0);
  };
  const auto on_q = [&](const Vector3& x) {
    return along(q, v, vv > 0 ? std::clamp(dot(minus(x, q), v) / vv, 0.0, 1.0) : 0);
  };
  double least = std::min({squared_apart(p, on_q(p)), squared_apart(p_end, on_q(p_end)),
                           squared_apart(q, on_p(q)), squared_apart(q_end, on_p(q_end))});
  const double parallel = uu * vv - uv * uv;
  if (parallel > 0) {
    const Vector3 w = minus(p, q);
    const double at = std::clamp((uv * dot(v, w) - vv * dot(u, w)) / parallel, 0.0, 1.0);
    const Vector3 of_p = along(p, u, at);
    least = std::min(least, squared_apart(of_p, on_q(of_p)));
  }
  return least;
}

/// Whether the segment passes through the triangle's inside.
bool pierces(const Vector3& from, const Vector3& to, const DrawnTriangle& triangle) {
  const Vector3 normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  const double above = dot(minus(from, triangle[0]), normal);
  const double below = dot(minus(to, triangle[0]), normal);
  if (above == below || (above > 0) == (below > 0)) {
    return false;
  }
  const Vector3 at = along(from, minus(to, from), above / (above - below));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 edge = minus(triangle[(i + 1) % 3], triangle[i]);
    if (dot(cross(edge, minus(at, triangle[i])), normal) < 0) {
      return false;
    }
  }
  return true;
}

/// The squared distance of a point above the triangle; edges cover the other points.
double squared_above(const Vector3& p, const DrawnTriangle& triangle) {
  const Vector3 normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  const double squared = dot(normal, normal);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 edge = minus(triangle[(i + 1) % 3], triangle[i]);
    if (dot(cross(edge, minus(p, triangle[i])), normal) < 0) {
      return HUGE_VAL;
    }
  }
  const double height = dot(minus(p, triangle[0]), normal);
  return squared > 0 ? height * height / squared : HUGE_VAL;
}

double middle(const DrawnTriangle& triangle, std::size_t axis) {
  return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
}

}  // namespace

double distance_between(const DrawnTriangle& p, const DrawnTriangle& q) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& p_end = p[(i + 1) % 3];
    if (pierces(p[i], p_end, q) || pierces(q[i], q[(i + 1) % 3], p)) {
      return 0;
    }
    least = std::min({least, squared_above(p[i], q), squared_above(q[i], p)});
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min(least, squared_edges(p[i], p_end, q[j], q[(j + 1) % 3]));
    }
  }
  return std::sqrt(least);
}

double distance_between(const DrawnTriangle& p, const Vector3& q) {
  double least = squared_above(q, p);
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min(least, squared_edges(p[i], p[(i + 1) % 3], q, q));
  }
  return std::sqrt(least);
}

std::vector<DrawnTriangle> triangles_of(const bake::SourceMesh& mesh) {
  std::vector<DrawnTriangle> triangles;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    triangles.push_back(
        {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]});
  }
  return triangles;
}

DrawnMesh::DrawnMesh(std::vector<DrawnTriangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) {
    build(0, static_cast<std::uint32_t>(triangles_.size()));
  }
}

void DrawnMesh::build(std::uint32_t first, std::uint32_t count) {
  Vector3 low = triangles_[first][0];
  Vector3 high = low;
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Vector3& corner : triangles_[i]) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
    }
  }
  const Vector3 half = {(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2};
  const std::size_t number = nodes_.size();
  nodes_.push_back({along(low, half, 1), half, first, count});
  if (count <= kLeafSize) {
    return;
  }
  const auto axis =
      static_cast<std::size_t>(std::max_element(half.begin(), half.end()) - half.begin());
  const auto begin = triangles_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [axis](const DrawnTriangle& p, const DrawnTriangle& q) {
                     return middle(p, axis) < middle(q, axis);
                   });
  build(first, count / 2);
  nodes_[number].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[number].count = 0;
  build(first + count / 2, count - count / 2);
}

/// A lower bound of the distance of two boxes.
double DrawnMesh::gap(const Query& query, const Node& a, const Node& b) const {
  const Vector3 centre = placed(query.frame, b.centre);
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double reach = a.half[i];
    for (std::size_t j = 0; j < 3; ++j) {
      reach += std::fabs(query.frame.rotation[i][j]) * b.half[j];
    }
    const double apart = std::max(std::fabs(centre[i] - a.centre[i]) - reach, 0.0);
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

bool DrawnMesh::are_leaves_nearer(const Query& query, const Node& a, const Node& b) const {
  for (std::uint32_t j = b.first; j < b.first + b.count; ++j) {
    DrawnTriangle of_b = query.b.triangles_[j];
    for (Vector3& corner : of_b) {
      corner = placed(query.frame, corner);
    }
    for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
      if (distance_between(triangles_[i], of_b) < query.distance) {
        return true;
      }
    }
  }
  return false;
}

bool DrawnMesh::is_nearer(const Query& query, std::uint32_t a, std::uint32_t b) const {
  const Node& of_a = nodes_[a];
  const Node& of_b = query.b.nodes_[b];
  if (gap(query, of_a, of_b) >= query.distance) {
    return false;
  }
  if (of_a.count != 0 && of_b.count != 0) {
    return are_leaves_nearer(query, of_a, of_b);
  }
  if (of_b.count != 0 || (of_a.count == 0 && of_a.size() > of_b.size())) {
    return is_nearer(query, a + 1, b) || is_nearer(query, of_a.first, b);
  }
  return is_nearer(query, a, b + 1) || is_nearer(query, a, of_b.first);
}

bool DrawnMesh::is_nearer(const DrawnMesh& other, const tool::Transform& frame,
                          double distance) const {
  return !is_empty() && !other.is_empty() && is_nearer(Query{other, frame, distance}, 0, 0);
}

double DrawnMesh::distance_to(const Vector3& p, double most) const {
  approach(p, 0, most);
  return most;
}

void DrawnMesh::approach(const Vector3& p, std::uint32_t number, double& least) const {
  const Node& node = nodes_[number];
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double apart = std::max(std::fabs(p[i] - node.centre[i]) - node.half[i], 0.0);
    squared += apart * apart;
  }
  if (std::sqrt(squared) >= least) {
    return;
  }
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    least = std::min(least, distance_between(triangles_[i], p));
  }
  if (node.count == 0) {
    approach(p, number + 1, least);
    approach(p, node.first, least);
  }
}

}  // namespace flashbvh::test
