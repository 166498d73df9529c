// Triangle tests in binary32: signs of heights, then intervals on the line of both planes.
#pragma once

namespace compare {

struct Vec {
  float x, y, z;
  Vec operator+(const Vec& o) const { return {x + o.x, y + o.y, z + o.z}; }
  Vec operator-(const Vec& o) const { return {x - o.x, y - o.y, z - o.z}; }
};

inline float dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A triangle and its plane.
struct Flat {
  Vec corner[3];
  Vec normal;
  float offset;
};

inline Flat flat_of(const Vec& p, const Vec& q, const Vec& r) {
  const Vec normal = cross(q - p, r - p);
  return {{p, q, r}, normal, dot(normal, p)};
}

/// Heights of the corners over a plane.
struct Heights {
  float of[3];

  Heights(const Vec& normal, float offset, const Vec (&corner)[3])
      : of{dot(normal, corner[0]) - offset, dot(normal, corner[1]) - offset,
           dot(normal, corner[2]) - offset} {}
  bool are_on_one_side() const {
    return (of[0] > 0 && of[1] > 0 && of[2] > 0) || (of[0] < 0 && of[1] < 0 && of[2] < 0);
  }
};

/// An interval; low <= high.
struct Interval {
  float low, high;
};

inline float least(float x, float y) {
  return x < y ? x : y;
}
inline float most(float x, float y) {
  return x > y ? x : y;
}

inline Interval interval_of(const Vec (&corners)[3], const Vec& axis) {
  const float at[3] = {dot(corners[0], axis), dot(corners[1], axis), dot(corners[2], axis)};
  return {least(at[0], least(at[1], at[2])), most(at[0], most(at[1], at[2]))};
}

inline bool disjoint(const Interval& a, const Interval& b) {
  return a.high < b.low || b.high < a.low;
}

/// For coplanar triangles: separating axes are the normals of the edges within the plane.
inline bool coplanar_intersect(const Vec (&a)[3], const Vec (&b)[3], const Vec& normal) {
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

/// The triangle's intersection with the other plane, as an interval on the line of both planes.
/// `at`: its corners projected on the line; `height`: their heights over the plane.
inline Interval crossed(const float (&at)[3], const float (&height)[3]) {
  // The corner alone on one side of the plane.
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

/// True if two triangles intersect; neither may lie on one side of the other's plane. Intervals on
/// the line of both planes (Moeller, A Fast Triangle-Triangle Intersection Test, 1997), without
/// tolerance.
inline bool crossing_intersect(const Vec (&a)[3], const Vec (&b)[3], const Vec& normal_a,
                               const Vec& normal_b, const Heights& of_a, const Heights& of_b) {
  if (of_a.of[0] == 0 && of_a.of[1] == 0 && of_a.of[2] == 0) {
    return coplanar_intersect(a, b, normal_a);
  }
  const Vec line = cross(normal_a, normal_b);
  // Projects on the axis along which the line is longest, which replaces a product.
  const float x = line.x < 0 ? -line.x : line.x;
  const float y = line.y < 0 ? -line.y : line.y;
  const float z = line.z < 0 ? -line.z : line.z;
  const float Vec::*axis = x >= y && x >= z ? &Vec::x : y >= z ? &Vec::y : &Vec::z;
  const float along_a[3] = {a[0].*axis, a[1].*axis, a[2].*axis};
  const float along_b[3] = {b[0].*axis, b[1].*axis, b[2].*axis};
  return !disjoint(crossed(along_a, of_a.of), crossed(along_b, of_b.of));
}

}  // namespace compare
