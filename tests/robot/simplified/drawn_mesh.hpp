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
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      balls_.push_back(ball_of(i, i + 1));
    }
    for (std::size_t i = 0; i < triangles_.size(); i += kGroup) {
      groups_.push_back(ball_of(i, end_of(i)));
    }
  }

  /// Tests all pairs of triangles whose balls, and whose groups' balls, are near. `frame`: the
  /// frame of `other` in this mesh's frame.
  bool is_nearer(const DrawnMesh& other, const tool::Transform& frame, double distance) const {
    for (std::size_t b = 0; b < other.groups_.size(); ++b) {
      const Ball of_b = {placed(frame, other.groups_[b].centre), other.groups_[b].radius};
      for (std::size_t a = 0; a < groups_.size(); ++a) {
        if (gap(groups_[a], of_b) < distance &&
            is_group_nearer(a * kGroup, other, b * kGroup, frame, distance)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  /// Consecutive triangles lie together.
  static constexpr std::size_t kGroup = 16;

  struct Ball {
    Vector3 centre{};
    double radius = 0;
  };
  static double gap(const Ball& a, const Ball& b) {
    return std::sqrt(squared(minus(a.centre, b.centre))) - a.radius - b.radius;
  }

  std::size_t end_of(std::size_t group) const {
    return std::min(group + kGroup, triangles_.size());
  }

  Ball ball_of(std::size_t begin, std::size_t end) const {
    Ball ball;
    const double part = 1.0 / (3.0 * static_cast<double>(end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      for (const Vector3& corner : triangles_[i]) {
        ball.centre = plus(ball.centre, part, corner);
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      for (const Vector3& corner : triangles_[i]) {
        ball.radius = std::max(ball.radius, std::sqrt(squared(minus(corner, ball.centre))));
      }
    }
    return ball;
  }

  bool is_group_nearer(std::size_t group, const DrawnMesh& other, std::size_t of_other,
                       const tool::Transform& frame, double distance) const {
    for (std::size_t j = of_other; j < other.end_of(of_other); ++j) {
      const Ball ball = {placed(frame, other.balls_[j].centre), other.balls_[j].radius};
      FloatTriangle triangle = other.triangles_[j];
      for (Vector3& corner : triangle) {
        corner = placed(frame, corner);
      }
      for (std::size_t i = group; i < end_of(group); ++i) {
        if (gap(balls_[i], ball) < distance &&
            std::sqrt(squared_distance(triangles_[i], triangle)) < distance) {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<FloatTriangle> triangles_;
  std::vector<Ball> balls_;   ///< of each triangle
  std::vector<Ball> groups_;  ///< of each kGroup triangles
};

}  // namespace flashbvh::test
