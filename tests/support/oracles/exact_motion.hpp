// The oracle for motions: the points of B at any moment, by Rodrigues' formula in doubles, and the
// distance of two bodies there. Uses no code of the library.
#pragma once

#include <vector>

#include "flashbvh/first_contact.hpp"
#include "flashbvh/mesh.hpp"
#include "support/oracles/float_distance.hpp"

namespace flashbvh::test {

using FloatMesh = std::vector<FloatTriangle>;

/// A mesh in cells of its own frame, in the order of its triangles.
inline FloatMesh float_mesh(const Mesh& mesh) {
  FloatMesh all(mesh.triangle_count);
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& v = mesh.vertices[mesh.triangles[i].corner[k]];
      all[i][k] = {double(v.x) + mesh.origin[0], double(v.y) + mesh.origin[1],
                   double(v.z) + mesh.origin[2]};
    }
  }
  return all;
}

inline FloatVector in_cells(const int32_t (&v)[3]) {
  return {v[0] / 2048.0, v[1] / 2048.0, v[2] / 2048.0};
}

/// A point that a pose transforms, without rounding.
inline FloatVector placed(const Pose& pose, const FloatVector& p) {
  FloatVector at;
  for (int i = 0; i < 3; ++i) {
    at[static_cast<std::size_t>(i)] =
        (pose.rotation(i, 0) * p[0] + pose.rotation(i, 1) * p[1] + pose.rotation(i, 2) * p[2]) /
            kRotationOne +
        pose.translation(i) + pose.fraction(i) / 65536.0;
  }
  return at;
}

/// A move at one moment.
class FloatMove {
 public:
  /// `time`: 0 (start) to 1 (end).
  FloatMove(const Move& move, double time) : point_(in_cells(move.point)), turns_(move.turn != 0) {
    const FloatVector given = {double(move.axis[0]), double(move.axis[1]), double(move.axis[2])};
    const double angle = time * move.turn / kFullTurn * 2 * 3.14159265358979323846;
    axis_ = turns_ ? times(1 / length_of(given), given) : given;
    sine_ = std::sin(angle);
    cosine_ = std::cos(angle);
    travel_ = times(time, in_cells(move.travel));
  }
  FloatVector operator()(const FloatVector& p) const {
    if (!turns_) {
      return plus(p, 1, travel_);
    }
    const FloatVector from = minus(p, point_);
    const FloatVector across = plus(times(cosine_, from), sine_, cross(axis_, from));
    return plus(plus(plus(across, (1 - cosine_) * dot(axis_, from), axis_), 1, point_), 1, travel_);
  }

 private:
  FloatVector point_, axis_, travel_;
  double sine_, cosine_;
  bool turns_;
};

class ExactMotion {
 public:
  explicit ExactMotion(const BodyMotion& motion) : motion_(motion) {}

  FloatVector at(double time, FloatVector p) const {
    p = placed(motion_.from(), p);
    for (std::uint32_t i = motion_.move_count(); i-- > 0;) {
      p = FloatMove(motion_.move(i), time)(p);
    }
    return p;
  }
  /// A mesh of B in A's frame.
  FloatMesh at(double time, const FloatMesh& mesh) const {
    const FloatVector o = at(time, FloatVector{0, 0, 0});
    const FloatVector axes[3] = {minus(at(time, FloatVector{1, 0, 0}), o),
                                 minus(at(time, FloatVector{0, 1, 0}), o),
                                 minus(at(time, FloatVector{0, 0, 1}), o)};
    FloatMesh moved = mesh;
    for (FloatTriangle& t : moved) {
      for (FloatVector& p : t) {
        p = plus(plus(plus(o, p[0], axes[0]), p[1], axes[1]), p[2], axes[2]);
      }
    }
    return moved;
  }

  /// An upper bound of the speed of the mesh's points, in cells per motion.
  double speed(const FloatMesh& mesh) const {
    double reach = 0;
    for (const FloatTriangle& t : mesh) {
      for (const FloatVector& p : t) {
        reach = std::max(reach, length_of(placed(motion_.from(), p)));
      }
    }
    double sum = 0;
    for (std::uint32_t i = motion_.move_count(); i-- > 0;) {
      const Move& move = motion_.move(i);
      const double point = move.turn == 0 ? 0 : length_of(in_cells(move.point));
      const double travel = length_of(in_cells(move.travel));
      sum += std::abs(double(move.turn)) / kFullTurn * 6.2831854 * (reach + point) + travel;
      reach += 2 * point + travel;
    }
    return sum;
  }

 private:
  const BodyMotion& motion_;
};

/// The least distance of all pairs of triangles, not below `enough`.
inline double distance_of(const FloatMesh& a, const FloatMesh& b, double enough = 0) {
  double least = std::numeric_limits<double>::infinity();
  for (const FloatTriangle& t : a) {
    for (const FloatTriangle& u : b) {
      const auto size = [](const FloatTriangle& of) {
        return std::sqrt(std::max(squared(minus(of[1], of[0])), squared(minus(of[2], of[0]))));
      };
      if (least > enough && length_of(minus(t[0], u[0])) - size(t) - size(u) < least) {
        least = std::min(least, std::sqrt(squared_distance(t, u)));
      }
    }
  }
  return least;
}

}  // namespace flashbvh::test
