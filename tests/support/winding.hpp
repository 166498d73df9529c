// The winding number of a closed mesh by another way than the library's: solid angles.
#ifndef FLASHBVH_TESTS_SUPPORT_WINDING_HPP
#define FLASHBVH_TESTS_SUPPORT_WINDING_HPP

#include <cmath>

#include "flashbvh/lattice.hpp"

namespace flashbvh::test {

inline double length_of(const double (&v)[3]) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Of a triangle, seen from a point that is not on it; positive where it turns its back to the
/// point. Source: Van Oosterom and Strackee, IEEE Transactions on Biomedical Engineering 30(2),
/// 1983.
inline double solid_angle(const Triangle& t, const Point& p) {
  double v[3][3];
  for (int i = 0; i < 3; ++i) {
    v[i][0] = t.corner[i].x - p.x;
    v[i][1] = t.corner[i].y - p.y;
    v[i][2] = t.corner[i].z - p.z;
  }
  const auto dot = [&](int i, int j) {
    return v[i][0] * v[j][0] + v[i][1] * v[j][1] + v[i][2] * v[j][2];
  };
  const double volume = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                        v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                        v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  const double a = length_of(v[0]);
  const double b = length_of(v[1]);
  const double c = length_of(v[2]);
  return 2 * std::atan2(volume, a * b * c + dot(0, 1) * c + dot(1, 2) * a + dot(2, 0) * b);
}

/// Of the sum of all triangles' angles.
inline long winding_of(double angles) {
  return std::lround(angles / (4 * 3.14159265358979323846));
}

}  // namespace flashbvh::test

#endif
