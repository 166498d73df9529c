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

bool triangles_intersect(const Vec (&a)[3], const Vec (&b)[3]);

}  // namespace compare

#endif
