// The distance of two triangles: exact, as a fraction of squared cells.
//
// Triangles that do not intersect are nearest between two of their features: a corner above a face,
// two edges, a corner and an edge, or two corners. Each of the 42 pairs counts if the nearest
// points of the planes, lines or points lie inside both features. The value of such a pair is never
// below the distance, and the least value is the distance. So "within" is a disjunction of
// comparisons, in any order.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/lattice/packed_vector.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/triangle.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// Largest difference along one axis between any two of the six corners, in cells. It keeps the
/// numerators below less than 2^108 and the denominators less than 2^72.
constexpr int32_t kMaxApart = (1 << 17) - 1;
/// kMaxApart for two meshes' triangles, whose edges are shorter: numerators and denominators are no
/// larger. Functions that need kMaxApart say so.
constexpr int32_t kMaxFarApart = (1 << 20) + (1 << 16);

/// The features between which two triangles are nearest.
enum class FeatureKind : uint8_t {
  intersection,  ///< none: they have a point in common
  corners,       ///< corner `of_a` and corner `of_b`
  corner_edge,   ///< corner `of_a` and the edge of B from corner `of_b` on
  edge_corner,   ///< the edge of A from corner `of_a` on and corner `of_b`
  edges,         ///< the edges from corner `of_a` and from corner `of_b` on
  corner_face,   ///< corner `of_a` and B's face
  face_corner,   ///< A's face and corner `of_b`
};
struct Features {
  FeatureKind kind;
  uint8_t of_a;
  uint8_t of_b;
};

/// True if the squared distance of `a` and `b` is below `squared`. Then sets `squared` to it, and
/// `features` to the nearest features, the first tested of equal ones. Differences: within
/// kMaxApart, or kMaxFarApart; this is not checked.
bool is_nearer(const Triangle& a, const Triangle& b, Fraction& squared,
               Features& features) noexcept;

/// The squared distance, as of is_nearer(), of triangles that are nearest between these features.
Fraction squared_between(const Triangle& a, const Triangle& b, const Features& features) noexcept;

/// Gets the nearest points and the distance of such triangles, rounded.
void get_nearest_points(const Triangle& a, const Triangle& b, const Features& features,
                        const Fraction& squared, NearestPoints& nearest) noexcept;

/// True if the squared distance is at most `squared`.
bool is_within(const Triangle& a, const Triangle& b, const ShortFraction& squared) noexcept;

/// The largest whole number whose root, plus `tolerance` in 2^-16 of it, is below the root of
/// `squared`; -1 if `squared` is 0. Pairs with a larger squared gap, which is whole, are no nearer,
/// but for the tolerance.
int64_t largest_below(const Fraction& squared, uint16_t tolerance) noexcept;

/// The squared distance of the triangles' boxes: the sum of squared gaps, below 2^36.
int64_t squared_box_gap(const Triangle& a, const Triangle& b) noexcept;

/// The planes through the nearest points of two triangles, normal to the line between them. Two
/// triangles are no nearer if two parallel planes, as far apart or farther, lie between them. The
/// test is exact, so that it finds equal distances, too.
class SupportPlanes {
 public:
  SupportPlanes() : is_any_(false) {}
  /// `features`: the nearest features of the triangles, which do not intersect.
  SupportPlanes(const Triangle& a, const Triangle& b, const Features& features) noexcept;

  /// Allows differences beyond kMaxApart, for triangles of meshes.
  void widen() noexcept { rest_ = rest_ == 0 ? uint16_t{0} : kWideRest; }

  /// True if such planes lie between two triangles. Differences: within kMaxApart.
  bool separates(const Triangle& a, const Triangle& b) const noexcept;
  /// The direction from A to B, rounded: the largest component has 13 bits. {0, 0}: no planes.
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
  [[gnu::__noinline__]] bool separates_exactly(const Triangle& a, const Triangle& b) const noexcept;

  // The normal, scaled, in two parts.
  int32_t high_[3];
  uint32_t low_[3];
  static constexpr uint16_t kRest = 1 << 4;
  static constexpr uint16_t kWideRest = 1 << 6;
  // The distance of the planes along it, in two parts.
  uint32_t low_apart_;
  bool is_any_;
  uint16_t rest_;  ///< the most by which low parts change a sum, in 2^16; 0 if there are none
  int64_t high_apart_;
};

/// A direction of 10 bits per component, in a word; 0: none.
struct Direction {
  uint32_t packed = 0;
};

/// True if the triangles' squared gap along some direction is `limit` + 1 or more; `limit`: below
/// 2^35. Tries `first` and six steps of Gilbert's, which approach the direction between the nearest
/// points. Sets `first` to the direction that separates.
///
/// Source: Gilbert, "An Iterative Procedure for Computing the Minimum of a Quadratic Form on a
/// Convex Set", SIAM Journal on Control 4, 1966.
bool directions_separate(const Triangle& a, const Triangle& b, int64_t limit,
                         Direction& first) noexcept;

/// True if the squared distance of the triangles' boxes is `limit` + 1 or more; then sets
/// `direction` to that of the gap.
bool boxes_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept;

/// directions_separate() along the normal of both triangles' longest edges: for two slivers,
/// between whose corners Gilbert's steps alternate.
bool edges_separate(const Triangle& a, const Triangle& b, int64_t limit,
                    Direction& direction) noexcept;

/// True if the triangles have a gap along the direction between their middles: exact, so that it is
/// false for triangles that touch. Separates most neighbours on a surface, which planes do not.
bool middles_separate(const Triangle& a, const Triangle& b) noexcept;

/// True if one triangle lies on one side of the other's plane, at a squared distance of `limit` + 1
/// or more; `limit`: below 2^35. Rarely false if the planes separate.
bool planes_separate(const Triangle& a, const Triangle& b, int64_t limit) noexcept;

/// A point of a triangle: corner `origin` plus (first, second) / below of the vectors from there to
/// the other two corners, in the order of corners.
struct PlaceInTriangle {
  uint8_t origin;
  Int128 first;
  Int128 second;
  Int128 below;
};

/// Gets the places of the nearest points that is_nearer() found; not for an intersection.
void nearest_places(const Triangle& a, const Triangle& b, const Features& features,
                    PlaceInTriangle& of_a, PlaceInTriangle& of_b) noexcept;

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
