// Nearest points of two triangles, rounded to 1/256 cell.
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/triangle.hpp"
#include "long_division.hpp"

namespace flashbvh {
namespace detail {
namespace {

/// Offset of a place from its corner along an axis, times `below`.
Int128 way_along(const Triangle& t, const PlaceInTriangle& place, int32_t Point::*axis) {
  const unsigned i = place.origin;
  const unsigned j = i == 2 ? 0 : i + 1;
  const unsigned k = j == 2 ? 0 : j + 1;
  return times(place.first, t.corner[j].*axis - t.corner[i].*axis) +
         times(place.second, t.corner[k].*axis - t.corner[i].*axis);
}

/// Coordinate of a place, rounded to the nearest 1/256 cell.
[[gnu::noinline]] int64_t fine_coordinate(const Triangle& t, const PlaceInTriangle& place,
                                          int32_t Point::*axis) {
  const Int128 way = way_along(t, place, axis);
  if (is_zero(way)) {
    return int64_t{t.corner[place.origin].*axis} * kFineOne;
  }
  const bool negative = way.high < 0;
  const Int128 twice = shifted_up(negative ? -way : way, 9) + place.below;
  const auto steps = static_cast<int64_t>(quotient(twice, shifted_up(place.below, 1)).low);
  return int64_t{t.corner[place.origin].*axis} * kFineOne + (negative ? -steps : steps);
}

FinePoint fine_point(const Triangle& t, const PlaceInTriangle& place) {
  return {fine_coordinate(t, place, &Point::x), fine_coordinate(t, place, &Point::y),
          fine_coordinate(t, place, &Point::z)};
}

/// Offset from a place of A to one of B along an axis, times the larger `below`. One place is a
/// corner, or both have one denominator.
[[gnu::noinline]] Int128 apart_along(const Triangle& a, const PlaceInTriangle& of_a,
                                     const Triangle& b, const PlaceInTriangle& of_b,
                                     int32_t Point::*axis) {
  const Int128& below = of_a.below < of_b.below ? of_b.below : of_a.below;
  const int32_t corners = b.corner[of_b.origin].*axis - a.corner[of_a.origin].*axis;
  return times(below, corners) + way_along(b, of_b, axis) - way_along(a, of_a, axis);
}

int leading_zeros(const Int128& u) {
  const Int128 size = u.high < 0 ? -u : u;
  return size.high != 0  ? __builtin_clzll(static_cast<uint64_t>(size.high))
         : size.low != 0 ? 64 + __builtin_clzll(size.low)
                         : 128;
}

/// Normalises a vector that is not 0.
[[gnu::noinline]] UnitVector unit_vector(const Int128 (&v)[3]) {
  int zeros = 128;
  for (const Int128& component : v) {
    const int own = leading_zeros(component);
    zeros = own < zeros ? own : zeros;
  }
  // Components get 61 bits and a sign; the root of the sum of squares has at most one bit more.
  int64_t scaled[3];
  Int128 squared = {0, 0};
  for (int i = 0; i < 3; ++i) {
    scaled[i] = shifted_up(v[i], static_cast<unsigned>(zeros - 1)).high >> 2;
    squared = squared + full_product(scaled[i], scaled[i]);
  }
  const auto length = static_cast<int64_t>(long_root(squared));
  const auto share = [&](int64_t component) {
    const bool negative = component < 0;
    const Int128 size = shifted_up(widened(negative ? -component : component), 31);
    const uint64_t twice = quotient(size, widened(length)).low;
    const auto rounded = static_cast<int32_t>((twice + 1) >> 1);
    return negative ? -rounded : rounded;
  };
  return {share(scaled[0]), share(scaled[1]), share(scaled[2])};
}

/// Sets the distance, the root of `squared`, in 1/256 cell, rounded down and up.
[[gnu::noinline]] void set_distance(const Fraction& squared, NearestPoints& nearest) {
  constexpr unsigned bits = 16;  // of kFineOne squared
  const Fraction fine = {shifted_up(squared.above, bits), squared.below};
  nearest.lower = static_cast<uint32_t>(long_root(quotient(fine.above, fine.below)));
  const auto root = static_cast<int64_t>(nearest.lower);
  const bool exact = compare({full_product(root, root), {0, 1}}, fine) == 0;
  nearest.upper = nearest.lower + (exact ? 0 : 1);
}

/// Sets both nearest points, and the vector from A's to B's, not to scale.
[[gnu::noinline]] void set_points(const Triangle& a, const Triangle& b, const Features& features,
                                  NearestPoints& nearest, Int128 (&apart)[3]) {
  PlaceInTriangle of_a{};
  PlaceInTriangle of_b{};
  nearest_places(a, b, features, of_a, of_b);
  nearest.point_a = fine_point(a, of_a);
  nearest.point_b = fine_point(b, of_b);
  apart[0] = apart_along(a, of_a, b, of_b, &Point::x);
  apart[1] = apart_along(a, of_a, b, of_b, &Point::y);
  apart[2] = apart_along(a, of_a, b, of_b, &Point::z);
}

[[gnu::noinline]] void set_contact(const Triangle& a, const Triangle& b, NearestPoints& nearest) {
  nearest.point_a = nearest.point_b = contact_of(a, b).ends[0];
}

}  // namespace

void get_nearest_points(const Triangle& a, const Triangle& b, const Features& features,
                        const Fraction& squared, NearestPoints& nearest) noexcept {
  nearest = {};
  set_distance(squared, nearest);
  if (features.kind == FeatureKind::intersection) {
    set_contact(a, b, nearest);
  } else {
    Int128 apart[3];
    set_points(a, b, features, nearest, apart);
    nearest.direction = unit_vector(apart);
  }
}

}  // namespace detail

NearestPoints nearest_points_of(const Triangle& a, const Triangle& b) noexcept {
  NearestPoints nearest;
  detail::Fraction squared = detail::kInfinite;
  detail::Features features{};
  (void)detail::is_nearer(a, b, squared, features);
  detail::get_nearest_points(a, b, features, squared, nearest);
  return nearest;
}

SquaredDistance squared_distance(const Triangle& a, const Triangle& b) noexcept {
  detail::Fraction squared = detail::kInfinite;
  detail::Features features{};
  (void)detail::is_nearer(a, b, squared, features);
  return {{static_cast<uint64_t>(squared.above.high), squared.above.low},
          {static_cast<uint64_t>(squared.below.high), squared.below.low}};
}

}  // namespace flashbvh
