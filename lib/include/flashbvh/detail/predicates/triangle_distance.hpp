// How far two triangles are apart: exactly, as a fraction of squared cells.
//
// Triangles that do not intersect are nearest between two of their features: a corner above a face,
// two edges, a corner and an edge, or two corners. Each of the 42 pairs counts where the nearest
// points of the planes, lines or points lie inside both features; what counts is never below the
// distance, and the least of it is the distance. So "within" is a disjunction of comparisons, and
// no order of them matters.
#ifndef FLASHBVH_DETAIL_PREDICATES_TRIANGLE_DISTANCE_HPP
#define FLASHBVH_DETAIL_PREDICATES_TRIANGLE_DISTANCE_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/triangle.hpp"

namespace flashbvh::detail {

/// Largest difference along one axis between any two of the six corners, in cells: then the
/// numerators below are less than 2^108 and the denominators less than 2^72.
constexpr int32_t kMaxApart = (1 << 17) - 1;
/// The same of two meshes' triangles, whose edges are shorter: numerators and denominators are no
/// larger. What needs kMaxApart says so.
constexpr int32_t kMaxFarApart = (1 << 20) + (1 << 16);

/// Between which features two triangles are nearest.
enum class FeatureKind : uint8_t {
  intersection,  ///< none: they have a point in common
  corners,       ///< corner `of_a` and corner `of_b`
  corner_edge,   ///< corner `of_a` and the edge of B from corner `of_b` on
  edge_corner,   ///< the other way round
  edges,         ///< the edges from corner `of_a` and from corner `of_b` on
  corner_face,   ///< corner `of_a` and B's face
  face_corner,   ///< A's face and corner `of_b`
};
struct Features {
  FeatureKind kind;
  uint8_t of_a;
  uint8_t of_b;
};

/// Whether the squared distance of `a` and `b` is below `squared`, which then is set to it, and
/// `features` to what is nearest; of equals the first that is looked at. Differences within
/// kMaxApart, or kMaxFarApart, which is not checked.
bool is_nearer(const Triangle& a, const Triangle& b, Fraction& squared,
               Features& features) noexcept;

/// The squared distance of triangles that are nearest between these features, as is_nearer() has
/// it.
Fraction squared_between(const Triangle& a, const Triangle& b, const Features& features) noexcept;

/// The same pair's points and distance, rounded.
void get_nearest_points(const Triangle& a, const Triangle& b, const Features& features,
                        const Fraction& squared, NearestPoints& nearest) noexcept;

/// Whether the squared distance is at most `squared`.
bool is_within(const Triangle& a, const Triangle& b, const ShortFraction& squared) noexcept;

/// The largest whole number whose root, and a tolerance in 2^-16 of it, is below the root of
/// `squared`; -1 if `squared` is 0. Pairs with a larger squared gap, which is whole, are no nearer,
/// but for that.
int64_t largest_below(const Fraction& squared, uint16_t tolerance) noexcept;

/// The square of the distance of the triangles' boxes: the sum of squared gaps, below 2^36.
int64_t squared_box_gap(const Triangle& a, const Triangle& b) noexcept;

/// The planes through the nearest points of two triangles, normal to the line between them. No two
/// triangles are nearer that planes parallel to these, as far apart or farther, have between them:
/// exactly, so that equal distances are found, too.
class SupportPlanes {
 public:
  SupportPlanes() : is_any_(false) {}
  /// Of triangles that do not intersect, between these features.
  SupportPlanes(const Triangle& a, const Triangle& b, const Features& features) noexcept;

  /// For differences beyond kMaxApart, of triangles of meshes.
  void widen() noexcept { rest_ = rest_ == 0 ? uint16_t{0} : kWideRest; }

  /// Whether two triangles have such planes between them. Differences within kMaxApart.
  bool separates(const Triangle& a, const Triangle& b) const noexcept;
  /// From A to B, rounded: the largest component has 13 bits. {0, 0}: there are no planes.
  PackedVector direction() const noexcept;

 private:
  /// 2^26 high + low.
  struct Along {
    int64_t high;
    uint32_t low;

    bool operator<(const Along& other) const {
      return high < other.high || (high == other.high && low < other.low);
    }
  };
  void set_normal(int64_t x, int64_t y, int64_t z, int64_t scale) noexcept;
  Along along(const Point& to, const Point& from) const noexcept;
  int64_t high_along(const Point& to, const Point& from) const noexcept {
    return int64_t{high_[0]} * (to.x - from.x) + int64_t{high_[1]} * (to.y - from.y) +
           int64_t{high_[2]} * (to.z - from.z);
  }
  [[gnu::noinline]] bool separates_exactly(const Triangle& a, const Triangle& b) const noexcept;

  // The normal, scaled, in two parts.
  int32_t high_[3];
  uint32_t low_[3];
  static constexpr uint16_t kRest = 1 << 4;
  static constexpr uint16_t kWideRest = 1 << 6;
  // How far the planes are apart along it, in two parts.
  uint32_t low_apart_;
  bool is_any_;
  uint16_t rest_;  ///< by what the low parts move a sum, at most, in 2^16; 0 if there are none
  int64_t high_apart_;
};

/// A direction of 10 bits a component, in a word; 0: none.
struct Direction {
  uint32_t packed = 0;
};

/// Whether some direction has the triangles so far apart that the square is `limit` + 1 or more;
/// the limit is below 2^35. Directions are tried that come nearer to the one between the nearest
/// points: six steps of Gilbert's, after `first`, which becomes the one that did.
///
/// Source: Gilbert, "An Iterative Procedure for Computing the Minimum of a Quadratic Form on a
/// Convex Set", SIAM Journal on Control 4, 1966.
bool directions_separate(const Triangle& a, const Triangle& b, int64_t limit,
                         Direction& first) noexcept;

/// Whether the boxes of the triangles are so far apart that the square is `limit` + 1 or more; the
/// direction becomes that of the gap.
bool boxes_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept;

/// The same along the normal of the longest edges of both: of two slivers, whose corners Gilbert's
/// steps go back and forth between.
bool edges_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept;

/// Whether the direction between the triangles' middles has them apart: with a gap, exactly, so
/// that it is false of triangles that touch. Detects most neighbours of a surface, which planes do
/// not.
bool middles_separate(const Triangle& a, const Triangle& b) noexcept;

/// Whether the plane of either triangle has the other one on one side, so far off that the square
/// is `limit` + 1 or more; the limit is below 2^35. Rarely false where the planes separate.
bool planes_separate(const Triangle& a, const Triangle& b, int64_t limit) noexcept;

/// A point of a triangle: corner `origin` and so much of the vectors from there to two others, in
/// the order of corners: (first, second) / below.
struct PlaceInTriangle {
  uint8_t origin;
  Int128 first;
  Int128 second;
  Int128 below;
};

/// Where the nearest points lie that is_nearer() found; not of an intersection.
void nearest_places(const Triangle& a, const Triangle& b, const Features& features,
                    PlaceInTriangle& of_a, PlaceInTriangle& of_b) noexcept;

}  // namespace flashbvh::detail

#endif
