// How far a body reaches in any direction, at most, with all that joints sweep of it. The function
// is convex, so between directions at which it is known, on the faces of an octahedron, what is
// interpolated is never too small.
#pragma once

#include <vector>

#include "apart.hpp"

namespace robot_check {

class Support {
 public:
  /// Of triangles.
  explicit Support(const Body& body);

  /// At least the largest dot product of the direction, of any length, and a point of the body.
  double operator()(const Vec& direction) const;
  /// All that a joint within its limits sweeps of it, in the frame of the joint's parent.
  Support swept(const Joint& joint) const;
  /// At least the distance of any point from the z axis.
  double from_axis() const;

 private:
  template <class Function>
  explicit Support(const Function& value);

  std::vector<double> values_;
};

/// Radians or cells; one turn of a joint without limits.
Range range_of(const Joint& joint);

}  // namespace robot_check
