// How far a body reaches in each direction: an upper bound of its support function
// h(u) = max over its points p of u . p, which says all of the body's convex hull.
//
// h is convex and of degree 1, so it is kept at the points of a grid on the surface of a cube, and
// what is between them is interpolated: a convex combination of values is never below that of h
// there. The error is of second order in the grid's step; nothing is ever understated.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_SUPPORT_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_SUPPORT_HPP

#include <vector>

#include "robot/kinematics.hpp"

namespace flashbvh::tool {

class Support {
 public:
  /// Of points, each of which may lie up to `deviation` elsewhere.
  Support(const std::vector<Vector3>& points, double deviation);

  /// At least h(direction), of a vector of any length.
  double operator()(const Vector3& direction) const;
  /// Of the body seen from another frame, which it lies in by `transform`.
  Support moved(const Transform& transform) const;
  /// Of all that the body sweeps as it turns about z over an interval, in radians.
  Support turned(const Interval& angles) const;
  /// The same, sliding along z.
  Support slid(const Interval& distances) const;
  /// How far from the z axis any of its points lies, at most.
  double reach() const;

 private:
  Support() = default;
  /// With h(direction) of each of the grid's points.
  template <class Function>
  static Support made(Function&& h);

  /// Over all that the turns make of a direction.
  template <class Turns>
  double most_of(const Vector3& direction, const Turns& turns) const;

  std::vector<double> values_;
};

}  // namespace flashbvh::tool

#endif
