#include "drawn_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::test {
namespace {

constexpr std::uint32_t kLeafSize = 2;

double middle(const FloatTriangle& triangle, std::size_t axis) {
  return triangle[0][axis] + triangle[1][axis] + triangle[2][axis];
}

}  // namespace

DrawnMesh::DrawnMesh(std::vector<FloatTriangle> triangles) : triangles_(std::move(triangles)) {
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
  const Vector3 half = plus({0, 0, 0}, 0.5, minus(high, low));
  const std::size_t number = nodes_.size();
  nodes_.push_back({plus(low, 1, half), half, first, count});
  if (count <= kLeafSize) {
    return;
  }
  const auto axis =
      static_cast<std::size_t>(std::max_element(half.begin(), half.end()) - half.begin());
  const auto begin = triangles_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [axis](const FloatTriangle& p, const FloatTriangle& q) {
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
    FloatTriangle of_b = query.b.triangles_[j];
    for (Vector3& corner : of_b) {
      corner = placed(query.frame, corner);
    }
    for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
      if (std::sqrt(squared_distance(triangles_[i], of_b)) < query.distance) {
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
  return !nodes_.empty() && !other.nodes_.empty() && is_nearer(Query{other, frame, distance}, 0, 0);
}

}  // namespace flashbvh::test
