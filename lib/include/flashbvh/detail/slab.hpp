// Slabs: what lies between two parallel planes, seen from the tree whose boxes are tested.
//
// A slab is a row as rotations have them (split_matrix.hpp): an integer direction, and where along
// it the leaf's triangles begin and end. Any direction separates rightly, so the direction of a
// plane or an edge may be rounded; what the slab holds is exact along the rounded one, or widened
// by what rotating it can add. It only ever rejects.
//
// Source: the separating axes of Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996, taken one by
// one; lib/docs/design.md, Leaves as shapes, derives the margins.
#ifndef FLASHBVH_DETAIL_SLAB_HPP
#define FLASHBVH_DETAIL_SLAB_HPP

#include <stdint.h>

#include "flashbvh/detail/box_packed.hpp"
#include "flashbvh/detail/inline.hpp"
#include "flashbvh/detail/packed_multiply.hpp"
#include "flashbvh/detail/split_matrix.hpp"
#include "flashbvh/detail/transform.hpp"

namespace flashbvh::detail {

/// A vertex, an edge or a direction: three signed halves.
struct PackedVector {
  uint32_t xy;  ///< x low, y high
  int32_t z;

  static PackedVector of(const Vertex& v) {
    return {join_halves(static_cast<uint16_t>(v.x), static_cast<uint16_t>(v.y)), v.z};
  }
  int32_t x() const { return static_cast<int16_t>(xy); }
  int32_t y() const { return static_cast<int32_t>(xy) >> 16; }
};

/// The largest component of a direction has so many bits and a sign. One more, and sums with an
/// offset and biases would leave 32 bits.
constexpr unsigned kDirectionBits = 13;

inline PackedVector operator-(const PackedVector& u, const PackedVector& v) {
  return {signed_difference(u.xy, v.xy), u.z - v.z};
}
inline int32_t dot(const PackedVector& u, const PackedVector& v) {
  return add_signed_products(u.z * v.z, u.xy, v.xy);
}

/// Where triangles lie along a direction.
struct Extent {
  int32_t least;
  int32_t most;

  void add(int32_t at) {
    least = at < least ? at : least;
    most = at > most ? at : most;
  }
};

/// Sets `direction` to that of u x v, scaled; false if that is 0. Components of u and v: within
/// +-32,766.
bool cross_direction(const PackedVector& u, const PackedVector& v, PackedVector& direction);

/// 20 bytes.
class Slab {
 public:
  /// Triangles of side `of` between these bounds along `direction`, both in its own lattice; boxes
  /// of the other side will be tested. `reach_b`: reach() of B's root box.
  void set(const PackedVector& direction, const Extent& extent, const Transform& transform, Side of,
           int32_t reach_b);

  /// The whole space.
  void set_all() {
    row_ = {0, 0, 0};
    least_upper_ = least_lower_ = INT32_MIN;
  }

  /// False only if the box has no point in the slab.
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) const {
    return add_products(add_products(add_products(0, row_.positive_xy, box.upper_xy),
                                     row_.negative_xy, box.lower_xy),
                        row_.z, box.z) >= least_upper_ &&
           add_crossed_products(add_products(add_products(0, row_.positive_xy, box.lower_xy),
                                             row_.negative_xy, box.upper_xy),
                                row_.z, box.z) >= least_lower_;
  }

 private:
  SplitRow row_;
  int32_t least_upper_;  ///< of a box's upper bound along the row, biased
  int32_t least_lower_;  ///< of its negated lower bound
};

}  // namespace flashbvh::detail

#endif
