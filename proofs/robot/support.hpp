// The largest extent of a body in any direction, with its sweep by joints. The support function is
// convex: interpolating between known directions, on an octahedron's faces, is never too small.
#pragma once

#include <vector>

#include "apart.hpp"

namespace robot_check {

class Support {
 public:
  /// The support of a body's triangles.
  explicit Support(const Body& body);

  /// An upper bound of the dot product of the direction, of any length, with any point of the body.
  double operator()(const Vec& direction) const;
  /// The support of the body's sweep by a joint within its limits, in the joint's parent's frame.
  Support swept(const Joint& joint) const;
  /// An upper bound of any point's distance from the z axis.
  double from_axis() const;

 private:
  template <class Function>
  explicit Support(const Function& value);

  std::vector<double> values_;
};

/// The joint's range in radians or cells; one turn for a joint without limits.
Range range_of(const Joint& joint);

}  // namespace robot_check
