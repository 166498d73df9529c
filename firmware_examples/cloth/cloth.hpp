// A cloth's motion: points and stretched edges, in float. It makes no queries.
//
// Each step moves the points by what they moved before, less the air, and by their weight; then
// edges are drawn to the length that they have in the baked sheet, some times over. Only sums,
// products, quotients and roots, which IEEE 754 rounds alike everywhere.
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
/// A point of a lattice, `offset` cells off.
Vector from(const flashbvh::Vertex& v, const Vector& offset);

/// What happens in a step, in cells of the lattice.
struct Setting {
  float weight;     ///< how much faster a step is than the one before
  float most;       ///< the longest way of a point in a step
  float floor;      ///< no point lies lower
  float thickness;  ///< triangles keep this far apart
};

/// `points` and `before`: memory for as many as the sheet has vertices.
class Cloth {
 public:
  Cloth(const flashbvh::Mesh& rest, const Setting& setting, Vector* points, Vector* before);

  void step();
  /// Triangle `position` off a plane of something rigid, in whose direction it was near.
  void push_off(uint32_t position, const Vector& on_plane, const Vector& normal);
  /// Two of the sheet's triangles apart.
  void push_apart(uint32_t a, uint32_t b);
  /// To whole cells.
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
