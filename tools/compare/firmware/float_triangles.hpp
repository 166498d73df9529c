// Whether two triangles intersect, in binary32: Moeller, A Fast Triangle-Triangle Intersection
// Test (1997), by intervals on the line of their planes. No tolerance.
#ifndef FLASHBVH_TOOLS_COMPARE_FIRMWARE_FLOAT_TRIANGLES_HPP
#define FLASHBVH_TOOLS_COMPARE_FIRMWARE_FLOAT_TRIANGLES_HPP

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

inline Vec normal_of(const Vec (&corner)[3]) {
  return cross(corner[1] - corner[0], corner[2] - corner[0]);
}

/// Of corners over a plane.
struct Heights {
  float of[3];

  Heights(const Vec& normal, float offset, const Vec (&corner)[3])
      : of{dot(normal, corner[0]) - offset, dot(normal, corner[1]) - offset,
           dot(normal, corner[2]) - offset} {}
  bool are_on_one_side() const {
    return (of[0] > 0 && of[1] > 0 && of[2] > 0) || (of[0] < 0 && of[1] < 0 && of[2] < 0);
  }
};

/// Whether two triangles intersect of which neither is on one side of the other's plane.
bool crossing_intersect(const Vec (&a)[3], const Vec (&b)[3], const Vec& normal_a,
                        const Vec& normal_b, const Heights& of_a, const Heights& of_b);

}  // namespace compare

#endif
