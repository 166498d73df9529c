// Meshes as drawn, in doubles, and whether two come near each other. Shares no code with the code
// that bakes, simplifies or guards them.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "robot/kinematics.hpp"
#include "support/surface.hpp"

namespace flashbvh::test {

using tool::Vector3;

class DrawnMesh {
 public:
  explicit DrawnMesh(std::vector<FloatTriangle> triangles) : triangles_(std::move(triangles)) {
    add_node(0, triangles_.size());
  }

  /// Tests all pairs of triangles whose nodes are near. `frame`: the frame of `other` in this
  /// mesh's frame.
  bool is_nearer(const DrawnMesh& other, const tool::Transform& frame, double distance) const {
    return is_nearer(0, {other, frame, inverse(frame), distance}, 0);
  }

  /// Upper bound on how far a point of this mesh moves from one frame to another.
  double way(const tool::Transform& from, const tool::Transform& to) const {
    const Node& all = nodes_.front();
    double turn = 0;
    for (std::size_t i = 0; i < 9; ++i) {
      turn += std::pow(to.rotation[i / 3][i % 3] - from.rotation[i / 3][i % 3], 2);
    }
    const Vector3 moved = minus(placed(to, all.centre), placed(from, all.centre));
    return std::sqrt(squared(moved)) + std::sqrt(turn) * all.radius;
  }

 private:
  /// The box and the ball of consecutive triangles. The left child follows its parent.
  struct Node {
    Vector3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Vector3 high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    Vector3 centre{};
    double radius = 0;
    std::size_t right = 0;  ///< the right child; 0: a leaf
    std::size_t triangle = 0;
  };
  struct Search {
    const DrawnMesh& other;
    tool::Transform frame;
    tool::Transform inverse;
    double distance;
  };

  /// How far a ball is from the node's box.
  static double gap(const Node& node, const Vector3& centre, double radius) {
    Vector3 apart{};
    for (std::size_t i = 0; i < 3; ++i) {
      apart[i] = std::max({node.low[i] - centre[i], centre[i] - node.high[i], 0.0});
    }
    return std::sqrt(squared(apart)) - radius;
  }

  void add_node(std::size_t begin, std::size_t end) {
    Node node;
    node.triangle = begin;
    for (std::size_t i = 9 * begin; i < 9 * end; ++i) {
      const double at = triangles_[i / 9][i / 3 % 3][i % 3];
      node.low[i % 3] = std::min(node.low[i % 3], at);
      node.high[i % 3] = std::max(node.high[i % 3], at);
    }
    node.centre = times(0.5, plus(node.low, 1, node.high));
    for (std::size_t i = 3 * begin; i < 3 * end; ++i) {
      const Vector3 from = minus(triangles_[i / 3][i % 3], node.centre);
      node.radius = std::max(node.radius, std::sqrt(squared(from)));
    }
    const std::size_t number = nodes_.size();
    nodes_.push_back(node);
    if (end - begin > 1) {
      const Vector3 size = minus(node.high, node.low);
      const std::size_t axis = size[0] > std::max(size[1], size[2]) ? 0 : size[1] > size[2] ? 1 : 2;
      std::sort(&triangles_[begin], &triangles_[begin] + (end - begin),
                [axis](const FloatTriangle& p, const FloatTriangle& q) {
                  return p[0][axis] + p[1][axis] + p[2][axis] <
                         q[0][axis] + q[1][axis] + q[2][axis];
                });
      add_node(begin, (begin + end) / 2);
      nodes_[number].right = nodes_.size();
      add_node((begin + end) / 2, end);
    }
  }

  bool is_nearer(std::size_t a, const Search& of, std::size_t b) const {
    const Node& u = nodes_[a];
    const Node& v = of.other.nodes_[b];
    if (gap(u, placed(of.frame, v.centre), v.radius) >= of.distance ||
        gap(v, placed(of.inverse, u.centre), u.radius) >= of.distance) {
      return false;
    }
    if (u.right == 0 && v.right == 0) {
      FloatTriangle triangle = of.other.triangles_[v.triangle];
      for (Vector3& corner : triangle) {
        corner = placed(of.frame, corner);
      }
      return std::sqrt(squared_distance(triangles_[u.triangle], triangle)) < of.distance;
    }
    return v.right == 0 || (u.right != 0 && u.radius > v.radius)
               ? is_nearer(a + 1, of, b) || is_nearer(u.right, of, b)
               : is_nearer(a, of, b + 1) || is_nearer(a, of, v.right);
  }

  std::vector<FloatTriangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace flashbvh::test
