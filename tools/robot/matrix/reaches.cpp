#include "robot/matrix/reaches.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Steps of a cube's edge from -1 to 1. Relative error of an interpolated value: about 1/(2 n^2).
constexpr std::size_t kSteps = 24;
constexpr std::size_t kPoints = kSteps + 1;
/// Parts of a full turn: a polygon round an arc has its corners 1/cos(half a part) as far out.
constexpr double kParts = 72;
/// Joints over which a swept volume keeps its shape; later it is a ball. Each takes milliseconds.
constexpr int kJointsKept = 12;
/// Covers the rounding of doubles: a few units in 2^52 each, a few hundred operations.
constexpr double kRoundUp = 1 + 1e-12;

/// The points of the grid. Face 2 k has coordinate k at -1, face 2 k + 1 at 1; a face's rows and
/// columns are the next two coordinates.
std::vector<Vector3> grid_points() {
  const auto at = [](std::size_t i) { return 2.0 * static_cast<double>(i) / kSteps - 1; };
  std::vector<Vector3> points;
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < kPoints * kPoints; ++i) {
      Vector3& point = points.emplace_back();
      point[face / 2] = face % 2 == 0 ? -1 : 1;
      point[(face / 2 + 1) % 3] = at(i / kPoints);
      point[(face / 2 + 2) % 3] = at(i % kPoints);
    }
  }
  return points;
}
const std::vector<Vector3> kGrid = grid_points();

/// A coordinate in grid steps: the point before it and the fraction of the step to the next point.
struct Step {
  std::size_t point;
  double part;
};

/// For coordinates from -1 to 1. Clamps the point, so that rounding can't leave the grid.
Step step_at(double coordinate) {
  const double steps = (coordinate + 1) / 2 * kSteps;
  const auto before = static_cast<std::size_t>(steps);
  const std::size_t point = before < kSteps ? before : kSteps - 1;
  return {point, steps - static_cast<double>(point)};
}

/// Turns a vector about z and scales its distance from z.
struct Turn {
  double c;
  double s;

  Vector3 operator()(const Vector3& vector) const {
    const double* const v = vector.data();
    return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
  }
};

/// Turns to the corners of a polygon round the arc of a vector that turns about z.
std::vector<Turn> turns_to_corners(const Interval& angles) {
  const double width = std::min(angles.upper - angles.lower, kTurn);
  const int parts = std::max(1, static_cast<int>(std::ceil(width / kTurn * kParts)));
  const double stretch = 1 / std::cos(width / parts / 2);
  std::vector<Turn> turns;
  const auto add = [&](double angle, double scale) {
    turns.push_back({std::cos(angle) * scale, std::sin(angle) * scale});
  };
  add(angles.lower, 1);
  for (int part = 0; part < parts; ++part) {
    add(angles.lower + (part + 0.5) * width / parts, stretch);
  }
  add(angles.lower + width, 1);
  return turns;
}

// An upper bound of a body's support function h(u) = max over its points p of u . p, which defines
// the body's convex hull.
//
// h is convex and homogeneous of degree 1. The bound is kept at the points of a grid on the surface
// of a cube and interpolated between them: a convex combination of values is never below h. So
// nothing is understated; the error is of second order in the grid's step.

class Support {
 public:
  /// The support of points, each of which may be displaced by up to `deviation`.
  Support(const std::vector<Vector3>& points, double deviation) {
    *this = made([&](const Vector3& u) {
      double most = -HUGE_VAL;
      for (const Vector3& p : points) {
        most = std::max(most, u[0] * p[0] + u[1] * p[1] + u[2] * p[2]);
      }
      return most + deviation * std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    });
  }

  /// At least h(direction), for a vector of any length.
  double operator()(const Vector3& direction) const {
    const double* const u = direction.data();
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      axis = std::fabs(u[i]) > std::fabs(u[axis]) ? i : axis;
    }
    const double scale = std::fabs(u[axis]);
    if (scale == 0) {
      return 0;
    }
    const Step row = step_at(u[(axis + 1) % 3] / scale);
    const Step column = step_at(u[(axis + 2) % 3] / scale);
    const std::size_t face = 2 * axis + (u[axis] > 0 ? 1 : 0);
    const double* const at = &values_[(face * kPoints + row.point) * kPoints + column.point];
    const auto between = [&](const double* pair) {
      return pair[0] + column.part * (pair[1] - pair[0]);
    };
    const double low = between(at);
    return scale * (low + row.part * (between(at + kPoints) - low));
  }

  /// The support in another frame, in which the body lies at `transform`, or at its inverse.
  Support moved(const Transform& transform) const {
    return made([&](const Vector3& u) {
      const Vector3& t = transform.translation;
      return (*this)(rotated_back(transform, u)) + u[0] * t[0] + u[1] * t[1] + u[2] * t[2];
    });
  }
  Support moved_back(const Transform& transform) const { return moved(inverse(transform)); }
  /// The support of the volume swept by turning about z over an interval, in radians.
  Support turned(const Interval& angles) const {
    // R p . u = p . R^-1 u
    const std::vector<Turn> turns = turns_to_corners({-angles.upper, -angles.lower});
    return made([&](const Vector3& u) { return most_of(u, turns); });
  }
  /// The support of the volume swept by sliding along z.
  Support slid(const Interval& distances) const {
    return made([&](const Vector3& u) {
      return (*this)(u) + std::max(distances.lower * u[2], distances.upper * u[2]);
    });
  }
  /// A bound on the distance of the body's points from the z axis.
  double reach() const { return most_of({1, 0, 0}, turns_to_corners({0, kTurn})) * kRoundUp; }
  /// A bound on their distance from the origin.
  double radius() const {
    double most = 0;
    for (std::size_t i = 0; i < kGrid.size(); ++i) {
      most = std::max(most, values_[i] / length_of(kGrid[i]));
    }
    // The farthest point's direction is within half a step of a grid point along both axes.
    constexpr double kNearest = 1 / (1 - 2.0 / (kSteps * kSteps));
    return most * kNearest * kRoundUp;
  }

 private:
  Support() = default;

  /// Stores h(direction) for each point of the grid.
  template <class Function>
  static Support made(const Function& h) {
    Support support;
    std::transform(kGrid.begin(), kGrid.end(), std::back_inserter(support.values_), h);
    return support;
  }

  /// The largest value over all images of the direction under `turns`.
  double most_of(const Vector3& direction, const std::vector<Turn>& turns) const {
    double most = -HUGE_VAL;
    for (const Turn& turn : turns) {
      most = std::max(most, (*this)(turn(direction)));
    }
    return most;
  }

  std::vector<double> values_;
};

/// A ball about the origin that holds a body, in place of a Support.
class Ball {
 public:
  explicit Ball(double radius) : radius_(radius) {}

  Ball moved(const Transform& transform) const {
    return Ball(radius_ + length_of(transform.translation) * kRoundUp);
  }
  Ball moved_back(const Transform& transform) const { return moved(transform); }
  Ball turned(const Interval& /*angles*/) const { return *this; }
  Ball slid(const Interval& distances) const {
    return Ball(radius_ + std::max(std::fabs(distances.lower), std::fabs(distances.upper)));
  }
  double reach() const { return radius_; }

 private:
  double radius_;
};

/// Visits body after body over the joints, with the volume that the link sweeps. A body is all that
/// is attached to a joint, in the joint's frame, or to the base.
class Spread {
 public:
  Spread(const Model& model, const Deadline& deadline)
      : model_(model), deadline_(deadline), reaches_(model.joints.size()) {}

  /// `from`: the joint crossed last, or none. `shape`: a Support, or the Ball that replaces it
  /// after `left` joints, or when time is up.
  template <class Shape>
  void visit(std::size_t body, std::size_t from, const Shape& shape, int left = kJointsKept) {
    if constexpr (std::is_same_v<Shape, Support>) {
      if (left == 0 || deadline_.is_past()) {
        visit(body, from, Ball(shape.radius()));
        return;
      }
    }
    if (body != kNoJoint && body != from) {
      reach(body, shape);
      const std::size_t parent = model_.joints[body].parent;
      if (leads_on(parent, body)) {
        visit(parent, body, swept(body, shape, false).moved(model_.joints[body].fixed), left - 1);
      }
    }
    for (std::size_t child = 0; child < model_.joints.size(); ++child) {
      if (model_.joints[child].parent == body && child != from) {
        const Shape seen = shape.moved_back(model_.joints[child].fixed);
        reach(child, seen);
        if (leads_on(child, child)) {
          visit(child, child, swept(child, seen, true), left - 1);
        }
      }
    }
  }

  const std::vector<double>& reaches() const { return reaches_; }

 private:
  /// True if the body has a joint other than the one crossed last.
  bool leads_on(std::size_t body, std::size_t from) const {
    const auto& joints = model_.joints;
    for (std::size_t child = 0; child < joints.size(); ++child) {
      if (joints[child].parent == body && child != from) {
        return true;
      }
    }
    return body != kNoJoint && body != from;
  }

  /// `shape`: in the joint's frame.
  template <class Shape>
  void reach(std::size_t number, const Shape& shape) {
    reaches_[number] = model_.joints[number].type == JointType::prismatic ? 1 : shape.reach();
  }

  /// The volume swept beyond a joint, in the joint's frame. Outward, from the parent's side to the
  /// child's, the parent's side moves backwards.
  template <class Shape>
  Shape swept(std::size_t number, const Shape& shape, bool outward) const {
    Interval range = range_of_joint(model_, number);
    if (outward) {
      range = {-range.upper, -range.lower};
    }
    return model_.joints[number].type == JointType::prismatic ? shape.slid(range)
                                                              : shape.turned(range);
  }

  const Model& model_;
  Deadline deadline_;
  std::vector<double> reaches_;
};

}  // namespace

std::vector<double> reaches_of(const Model& model, std::size_t link, double cell,
                               const Deadline& deadline) {
  Spread spread(model, deadline);
  const ModelLink& of = model.links[link];
  spread.visit(of.joint, kNoJoint, Support(of.mesh.vertices, kDeviation * cell));
  return spread.reaches();
}

Reaches all_reaches(const Model& model, double cell, const Deadline& deadline) {
  Reaches all(model.links.size());
  for_each_in_parallel(all.size(), [&](std::size_t link) {
    all[link] = reaches_of(model, link, cell, turn_of(deadline, all.size() - link, 1));
  });
  return all;
}

}  // namespace flashbvh::tool
