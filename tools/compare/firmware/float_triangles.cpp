#include "float_triangles.hpp"

namespace compare {
namespace {

/// From low to high.
struct Interval {
  float low, high;
};

float least(float x, float y) {
  return x < y ? x : y;
}
float most(float x, float y) {
  return x > y ? x : y;
}

Interval interval_of(const Vec (&corners)[3], const Vec& axis) {
  const float at[3] = {dot(corners[0], axis), dot(corners[1], axis), dot(corners[2], axis)};
  return {least(at[0], least(at[1], at[2])), most(at[0], most(at[1], at[2]))};
}

bool disjoint(const Interval& a, const Interval& b) {
  return a.high < b.low || b.high < a.low;
}

/// By the normals of the edges within the plane.
bool coplanar_intersect(const Vec (&a)[3], const Vec (&b)[3], const Vec& normal) {
  for (int i = 0; i < 3; ++i) {
    const Vec of_a = cross(normal, a[(i + 1) % 3] - a[i]);
    const Vec of_b = cross(normal, b[(i + 1) % 3] - b[i]);
    if (disjoint(interval_of(a, of_a), interval_of(b, of_a)) ||
        disjoint(interval_of(a, of_b), interval_of(b, of_b))) {
      return false;
    }
  }
  return true;
}

/// Where the triangle crosses the other's plane, along the line of both: `at` projects its corners
/// on the line, `height` is theirs over the plane.
Interval crossed(const float (&at)[3], const float (&height)[3]) {
  // The corner that is alone on its side.
  const int lone = height[0] * height[1] > 0                     ? 2
                   : height[0] * height[2] > 0                   ? 1
                   : height[1] * height[2] > 0 || height[0] != 0 ? 0
                   : height[1] != 0                              ? 1
                                                                 : 2;
  const int u = (lone + 1) % 3;
  const int v = (lone + 2) % 3;
  const float to_u = at[lone] + (at[u] - at[lone]) * height[lone] / (height[lone] - height[u]);
  const float to_v = at[lone] + (at[v] - at[lone]) * height[lone] / (height[lone] - height[v]);
  return {least(to_u, to_v), most(to_u, to_v)};
}

}  // namespace

bool crossing_intersect(const Vec (&a)[3], const Vec (&b)[3], const Vec& normal_a,
                        const Vec& normal_b, const Heights& of_a, const Heights& of_b) {
  if (of_a.of[0] == 0 && of_a.of[1] == 0 && of_a.of[2] == 0) {
    return coplanar_intersect(a, b, normal_a);
  }
  const Vec line = cross(normal_a, normal_b);
  // The axis along which the line is longest, in place of a product.
  const float x = line.x < 0 ? -line.x : line.x;
  const float y = line.y < 0 ? -line.y : line.y;
  const float z = line.z < 0 ? -line.z : line.z;
  const float Vec::*axis = x >= y && x >= z ? &Vec::x : y >= z ? &Vec::y : &Vec::z;
  const float along_a[3] = {a[0].*axis, a[1].*axis, a[2].*axis};
  const float along_b[3] = {b[0].*axis, b[1].*axis, b[2].*axis};
  return !disjoint(crossed(along_a, of_a.of), crossed(along_b, of_b.of));
}

}  // namespace compare
