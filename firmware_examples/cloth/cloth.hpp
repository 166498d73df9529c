// A cloth's motion: points and stretched edges, in float. It makes no queries.
//
// Each step moves the points by their last movement, less air drag, and by their weight. Then it
// draws edges towards their length in the baked sheet, several times. It uses only sums, products,
// quotients and roots, which IEEE 754 rounds alike everywhere.
//
// Source: Jakobsen, "Advanced Character Physics", Game Developers Conference 2001.
#pragma once

#include <flashbvh/deformable.hpp>

namespace cloth {

struct Vector {
  float x;
  float y;
  float z;
};

inline Vector operator+(const Vector& u, const Vector& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
inline Vector operator-(const Vector& u, const Vector& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
inline Vector operator*(float s, const Vector& v) {
  return {s * v.x, s * v.y, s * v.z};
}
inline float dot(const Vector& u, const Vector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
inline Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
/// A lattice point, moved by `offset` cells.
Vector from(const flashbvh::Vertex& v, const Vector& offset);

/// Parameters of a step, in cells of the lattice.
struct Setting {
  float weight;     ///< how much each step gains in speed over the last
  float most;       ///< the longest movement of a point per step
  float floor;      ///< the lowest height of a point
  float thickness;  ///< the distance that triangles keep
};

/// `points` and `before`: arrays of as many elements as the sheet has vertices.
class Cloth {
 public:
  Cloth(const flashbvh::Mesh& rest, const Setting& setting, Vector* points, Vector* before);

  void step();
  /// Pushes triangle `position` off a nearby plane of a rigid body, along the normal.
  void push_off(uint32_t position, const Vector& on_plane, const Vector& normal);
  /// Pushes two of the sheet's triangles apart.
  void push_apart(uint32_t a, uint32_t b);
  /// Writes the points, rounded to whole cells.
  void put_into(flashbvh::Vertex* vertices) const;

 private:
  void stretch(uint32_t u, uint32_t v);
  Vector normal_of(uint32_t position) const;
  Vector middle_of(uint32_t position) const;

  const flashbvh::Mesh& rest_;
  Setting setting_;
  Vector* points_;
  Vector* before_;
};

}  // namespace cloth
