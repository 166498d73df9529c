// Slabs: the space between two parallel planes, seen from the tree whose boxes are tested.
//
// A slab is a row of a matrix (split_matrix.hpp), which is an integer direction, and the extent of
// the leaf's triangles along it. Any direction separates correctly, so the direction of a plane or
// an edge may be rounded. The extent is exact along the rounded direction, or widened by the error
// of rotating it. A slab can only reject.
//
// Source: the separating axes of Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996, tested one by
// one; lib/docs/derivations.md, "Slabs of leaf planes", derives the margins.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed_multiply.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/lattice/baked_slab.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/lattice/split_matrix.hpp"

namespace flashbvh::detail {

/// The range of triangles along a direction.
struct Extent {
  int32_t least;
  int32_t most;

  /// `at`: less than 2^31 from either end.
  void add(int32_t at) {
#if defined(__ARM_FEATURE_SAT) && !defined(FLASHBVH_PORTABLE)
    least -= static_cast<int32_t>(__usat(least - at, 31));  // negative differences saturate to 0
    most += static_cast<int32_t>(__usat(at - most, 31));
#else
    least = at < least ? at : least;
    most = at > most ? at : most;
#endif
  }
  void add(const Extent& other) {
    least = other.least < least ? other.least : least;
    most = other.most > most ? other.most : most;
  }
};

/// Sets `direction` to that of u x v, scaled; false if that is 0. Components of u and v: within
/// +-32,766.
FLASHBVH_INLINE_FOR_SPEED inline bool cross_direction(const PackedVector& u, const PackedVector& v,
                                                      PackedVector& direction) {
  int32_t x = u.y() * v.z - u.z * v.y();
  int32_t y = u.z * v.x() - u.x() * v.z;
  int32_t z = cross_halves(u.xy, v.xy);
  // Negative components are complemented, which makes them smaller by one: still 13 bits.
  const uint32_t all = static_cast<uint32_t>((x ^ (x >> 31)) | (y ^ (y >> 31)) | (z ^ (z >> 31)));
  if ((x | y | z) == 0) {
    direction = {0, 0};
    return false;
  }
  // Shifts the largest component to the top, and from there down to its 13 bits.
  const int up = __builtin_clz(all | 1u) - 1;
  const auto scaled = [up](int32_t component) {
    return static_cast<int32_t>(static_cast<uint32_t>(component) << up) >>
           (31 - static_cast<int>(kDirectionBits));
  };
  direction = {join_halves(static_cast<uint16_t>(scaled(x)), static_cast<uint16_t>(scaled(y))),
               scaled(z)};
  return true;
}

/// A triangle on its lattice, and the directions of its slabs.
struct PackedTriangle {
  PackedVector p;
  PackedVector q;
  PackedVector r;

  /// The normal; false if the triangle has no area.
  FLASHBVH_INLINE_FOR_SPEED bool plane_direction(PackedVector& normal) const {
    return cross_direction(q - p, r - p, normal);
  }
  /// In the plane with this normal, the normal of the longest edge, the first of equal edges; false
  /// if the edge has no length.
  FLASHBVH_INLINE_FOR_SPEED bool edge_direction(const PackedVector& normal,
                                                PackedVector& direction) const {
    PackedVector longest = q - p;
    uint32_t most = squared(longest);
    const auto consider = [&](const PackedVector& edge) {
      const uint32_t length = squared(edge);
      if (length > most) {
        most = length;
        longest = edge;
      }
    };
    consider(r - q);
    consider(p - r);
    return cross_direction(longest, normal, direction);
  }
  FLASHBVH_INLINE_FOR_SPEED Extent extent(const PackedVector& direction) const {
    const int32_t at = dot(direction, p);
    Extent along = {at, at};
    along.add(dot(direction, q));
    along.add(dot(direction, r));
    return along;
  }
};

/// Made in two steps: first in the leaf's own lattice, then transformed to the other lattice.
/// 20 bytes.
class Slab {
 public:
  /// Sets the extent of triangles along `direction`, in their own lattice.
  FLASHBVH_INLINE void begin(const PackedVector& direction, const Extent& extent) {
    row_ = {direction.xy, 0, static_cast<uint32_t>(direction.z)};
    least_upper_ = extent.least;
    least_lower_ = extent.most;
  }
  FLASHBVH_INLINE void begin(const BakedSlab& baked) {
    begin(baked.direction, {baked.least, baked.most});
  }
  /// Stores a direction for later; sets nothing else.
  FLASHBVH_INLINE void keep_direction(const PackedVector& direction) {
    row_.positive_xy = direction.xy;
    row_.z = static_cast<uint32_t>(direction.z);
  }
  PackedVector direction() const { return {row_.positive_xy, static_cast<int32_t>(row_.z)}; }
  Extent extent() const { return {least_upper_, least_lower_}; }

  /// Transforms a slab of side `of` to the other tree's lattice, under a translation of B.
  FLASHBVH_INLINE_FOR_SPEED void translate(const Point& offset, Side of) {
    const PackedVector d = direction();
    const int32_t along = d.x() * offset.x + d.y() * offset.y + d.z * offset.z;
    set_row(d, of == Side::a ? -along : along, 0);
  }
  /// Transforms a slab under the rotation of a prepared transform. For a far B the slab stays as
  /// before the move, but is widened so that every box touches it.
  FLASHBVH_NOINLINE void rotate(const Transform& transform, Side of);

  /// Makes the slab the whole space.
  void set_all() {
    row_ = {0, 0, 0};
    least_upper_ = least_lower_ = INT32_MIN;
  }

  /// How far a box is from the slab, in units of its direction; 0 if it may touch.
  FLASHBVH_INLINE uint32_t gap(const PackedBox& box) const {
    const int32_t upper = add_products(add_products(add_products(0, row_.positive_xy, box.upper_xy),
                                                    row_.negative_xy, box.lower_xy),
                                       row_.z, box.z);
    if (upper < least_upper_) {  // the sum is positive, so that nothing wraps
      return static_cast<uint32_t>(least_upper_ - upper);
    }
    const int32_t lower =
        add_crossed_products(add_products(add_products(0, row_.positive_xy, box.lower_xy),
                                          row_.negative_xy, box.upper_xy),
                             row_.z, box.z);
    return lower < least_lower_ ? static_cast<uint32_t>(least_lower_ - lower) : 0;
  }
  /// The direction in the boxes' lattice, after translate() or rotate().
  PackedVector seen_direction() const {
    return {signed_difference(row_.positive_xy, row_.negative_xy), row_.z_entry()};
  }

  const SplitRow& row() const { return row_; }
  /// Lower limits, biased, for a box's upper bound along the row and for its negated lower bound.
  int32_t least_upper() const { return least_upper_; }
  int32_t least_lower() const { return least_lower_; }

  /// False only if the box has no point in the slab.
  FLASHBVH_INLINE_FOR_SPEED bool may_touch(const PackedBox& box) const {
    return add_products(add_products(add_products(0, row_.positive_xy, box.upper_xy),
                                     row_.negative_xy, box.lower_xy),
                        row_.z, box.z) >= least_upper_ &&
           add_crossed_products(add_products(add_products(0, row_.positive_xy, box.lower_xy),
                                             row_.negative_xy, box.upper_xy),
                                row_.z, box.z) >= least_lower_;
  }

  /// False only if all these vertices of the other tree lie on one side: `corner` to before `end`,
  /// at least one.
  template <class Index>
  FLASHBVH_INLINE_FOR_SPEED bool may_touch(const Vertex* vertices, const Index* corner,
                                           const Index* end) const {
    const PackedVector seen = seen_direction();
    const int32_t bias = row_.sum() * kBoundBias;
    const int32_t least = least_upper_ - bias;
    const int32_t least_negated = least_lower_ - bias;
    const auto along = [&](Index i) { return dot(seen, PackedVector::of(vertices[i])); };
    const int32_t first = along(*corner);
    if (first < least) {
      while (++corner != end && along(*corner) < least) {
      }
    } else if (-first < least_negated) {
      while (++corner != end && -along(*corner) < least_negated) {
      }
    }
    return corner != end;
  }

 private:
  FLASHBVH_INLINE_FOR_SPEED void set_row(const PackedVector& seen, int32_t offset, int32_t margin) {
    const Extent along = extent();
    row_ = {positive_halves(seen.xy), positive_halves(signed_difference(0, seen.xy)),
            positive_halves(
                join_halves(static_cast<uint16_t>(seen.z), static_cast<uint16_t>(-seen.z)))};
    const int32_t bias = row_.sum() * kBoundBias;
    least_upper_ = bias + along.least + offset - margin;
    least_lower_ = bias - along.most - offset - margin;
  }

  SplitRow row_;
  int32_t least_upper_;
  int32_t least_lower_;
};

}  // namespace flashbvh::detail
