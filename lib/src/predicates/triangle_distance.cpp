// Distances between the features of two triangles.
//
// One problem covers a corner r above a face with edges e and f, and two edges e, f whose starts
// are r apart: find the point of the plane of e and f nearest to r. With a = e.e, b = e.f, c = f.f
// it is s e + t f with
//     area = a c - b^2,    s area = c (r.e) - b (r.f),    t area = a (r.f) - b (r.e),
// and its squared distance from r is (r . (e x f))^2 / area.
#include "flashbvh/detail/predicates/triangle_distance.hpp"

#include "flashbvh/detail/predicates/triangle.hpp"
#include "triangle_range.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

// Products of two dot products, and sums of two products: in 64 bits if all differences are below
// 2^14, else in 128 bits.
struct In64 {
  using Product = int64_t;
  static Product product(int64_t u, int64_t v) { return u * v; }
};
struct In128 {
  using Product = Int128;
  static Product product(int64_t u, int64_t v) { return full_product(u, v); }
};
inline Int128 widened(const Int128& u) {
  return u;
}
using detail::widened;

/// Searches candidates for the least one below a limit, or for any one that is at most a limit.
class Search {
 public:
  // The candidate is set before it is considered.
  // NOLINTBEGIN(clang-analyzer-optin.cplusplus.UninitializedObject)

  /// Sets `limit` and `features` to those of the least candidate below `limit`.
  Search(Fraction& limit, Features& features) : least_(&limit), features_(&features) {}
  explicit Search(const ShortFraction& limit) : closed_limit_(&limit) {}
  // NOLINTEND(clang-analyzer-optin.cplusplus.UninitializedObject)

  /// True if no further candidate can change the result.
  bool is_over() const { return found_ && closed_limit_ != nullptr; }
  bool found() const { return found_; }

  /// The next candidate. It is a member, so that the stack frames of the functions that compute it
  /// are gone when it is compared.
  Fraction candidate;

  [[gnu::noinline]] void consider(Features features) {
    if (closed_limit_ != nullptr) {
      found_ = found_ || !is_above(candidate, *closed_limit_);
    } else if (compare(candidate, *least_) < 0) {
      found_ = true;
      *least_ = candidate;
      *features_ = features;
    }
  }

 private:
  Fraction* least_ = nullptr;
  Features* features_ = nullptr;
  const ShortFraction* closed_limit_ = nullptr;
  bool found_ = false;
};

/// The point of the plane of two vectors that is nearest to a given point, as shares of both
/// vectors, each times the squared area.
template <class Width>
struct Plane {
  using Product = typename Width::Product;
  int64_t ee;
  int64_t ef;
  int64_t ff;

  Plane(const Vector& e, const Vector& f) : ee(dot(e, e)), ef(dot(e, f)), ff(dot(f, f)) {}

  /// The squared area; 0 if there is no plane.
  Product area() const { return Width::product(ee, ff) - Width::product(ef, ef); }
  /// Shares for a point whose dot products with the vectors are `re` and `rf`.
  Product first(int64_t re, int64_t rf) const {
    return Width::product(ff, re) - Width::product(ef, rf);
  }
  Product second(int64_t re, int64_t rf) const {
    return Width::product(ee, rf) - Width::product(ef, re);
  }
};

/// Returns whether the point of the plane nearest to `r` lies strictly inside both edges (`edges`),
/// or else in the closed triangle of `e` and `f`. If so, sets `squared_area`.
template <class Width>
[[gnu::noinline]] bool is_over_plane(const Vector& e, const Vector& f, const Vector& r, bool edges,
                                     Int128& squared_area) {
  const Plane<Width> plane(e, f);
  const auto area = plane.area();
  if (sign_of(area) <= 0) {
    return false;
  }
  const int64_t re = dot(r, e);
  const int64_t rf = dot(r, f);
  const auto first = plane.first(re, rf);
  if (sign_of(first) < (edges ? 1 : 0) || !(edges ? first < area : sign_of(area - first) >= 0)) {
    return false;
  }
  const auto second = plane.second(re, rf);
  if (sign_of(second) < (edges ? 1 : 0) ||
      !(edges ? second < area : sign_of(area - first - second) >= 0)) {
    return false;
  }
  squared_area = widened(area);
  return true;
}

/// Signed distance of `r` from the plane of `e` and `f`, times the root of the squared area.
[[gnu::noinline]] int64_t height_of(const Vector& e, const Vector& f, const Vector& r) {
  return detail::dot(cross<LongVector>(e, f), r);
}

[[gnu::noinline]] void set_square(int64_t value, Int128& squared) {
  squared = full_product(value, value);
}

template <class Width>
inline bool height_above(const Vector& e, const Vector& f, const Vector& r, bool edges,
                         Fraction& squared) {
  if (!is_over_plane<Width>(e, f, r, edges, squared.below)) {
    return false;
  }
  set_square(height_of(e, f, r), squared.above);
  return true;
}

[[gnu::noinline]] void search_corners(const Triangle& a, const Triangle& b, Search& search) {
  int64_t least = INT64_MAX;
  uint8_t of_a = 0;
  uint8_t of_b = 0;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j) {
      const Vector apart = difference(b.corner[j], a.corner[i]);
      const int64_t squared = dot(apart, apart);
      if (squared < least) {
        least = squared;
        of_a = static_cast<uint8_t>(i);
        of_b = static_cast<uint8_t>(j);
      }
    }
  }
  search.candidate = {widened(least), widened(1)};
  search.consider({FeatureKind::corners, of_a, of_b});
}

/// Sets the squared distance of the point `r` from the line of `e`; false if the nearest point does
/// not lie strictly inside the edge.
template <class Width>
[[gnu::noinline]] bool beside(const Vector& e, const Vector& r, Fraction& squared) {
  const int64_t ee = dot(e, e);
  const int64_t re = dot(r, e);
  if (re <= 0 || re >= ee) {
    return false;
  }
  squared = {widened(Width::product(dot(r, r), ee) - Width::product(re, re)), widened(ee)};
  return true;
}

/// Considers corners of `of` and edges of `other`.
template <class Width>
[[gnu::noinline]] void search_beside_edges(const Triangle& of, const Triangle& other, bool swapped,
                                           Search& search) {
  for (uint8_t j = 0; j < 3; ++j) {
    const Vector e = edge_of(other, j);
    for (uint8_t i = 0; i < 3; ++i) {
      if (beside<Width>(e, difference(of.corner[i], other.corner[j]), search.candidate)) {
        search.consider(swapped ? Features{FeatureKind::edge_corner, j, i}
                                : Features{FeatureKind::corner_edge, i, j});
      }
    }
  }
}

template <class Width>
[[gnu::noinline]] void search_edges(const Triangle& a, const Triangle& b, Search& search) {
  for (uint8_t i = 0; i < 3; ++i) {
    const Vector e = edge_of(a, i);
    for (uint8_t j = 0; j < 3; ++j) {
      if (height_above<Width>(e, negated(edge_of(b, j)), difference(b.corner[j], a.corner[i]), true,
                              search.candidate)) {
        search.consider({FeatureKind::edges, i, j});
      }
    }
  }
}

/// Considers corners of `of` above the face of `other`.
template <class Width>
[[gnu::noinline]] void search_above_face(const Triangle& of, const Triangle& other, bool swapped,
                                         Search& search) {
  const Vector e = difference(other.corner[1], other.corner[0]);
  const Vector f = difference(other.corner[2], other.corner[0]);
  for (uint8_t i = 0; i < 3; ++i) {
    if (height_above<Width>(e, f, difference(of.corner[i], other.corner[0]), false,
                            search.candidate)) {
      search.consider(swapped ? Features{FeatureKind::face_corner, 0, i}
                              : Features{FeatureKind::corner_face, i, 0});
    }
  }
}

[[gnu::noinline]] bool above_face(const Point& corner, const Triangle& face, Fraction& squared) {
  return height_above<In128>(difference(face.corner[1], face.corner[0]),
                             difference(face.corner[2], face.corner[0]),
                             difference(corner, face.corner[0]), false, squared);
}

template <class Width>
void search_rest(const Triangle& a, const Triangle& b, Search& search) {
  search_beside_edges<Width>(a, b, false, search);
  if (search.is_over()) {
    return;
  }
  search_beside_edges<Width>(b, a, true, search);
  if (search.is_over()) {
    return;
  }
  search_edges<Width>(a, b, search);
  if (search.is_over()) {
    return;
  }
  search_above_face<Width>(a, b, false, search);
  search_above_face<Width>(b, a, true, search);
}

/// Whether all differences between the corners are below 2^14.
bool is_narrow(const Triangle& a, const Triangle& b) {
  const auto spans = [&](int32_t Point::*axis) {
    const Range of_a = range_of(a, axis);
    const Range of_b = range_of(b, axis);
    const int32_t least = of_a.least < of_b.least ? of_a.least : of_b.least;
    const int32_t most = of_a.most > of_b.most ? of_a.most : of_b.most;
    return most - least < 1 << 14;
  };
  return spans(&Point::x) && spans(&Point::y) && spans(&Point::z);
}

void search_all(const Triangle& a, const Triangle& b, Search& search) {
  search_corners(a, b, search);
  if (search.is_over()) {
    return;
  }
  if (is_narrow(a, b)) {
    search_rest<In64>(a, b, search);
  } else {
    search_rest<In128>(a, b, search);
  }
}

constexpr Fraction kZero = {{0, 0}, {0, 1}};

bool intersect(const Triangle& a, const Triangle& b) {
  return squared_box_gap(a, b) == 0 && triangles_intersect(a, b);
}

}  // namespace

int64_t largest_below(const Fraction& squared, uint16_t tolerance) noexcept {
  if (is_zero(squared.above)) {
    return -1;
  }
  constexpr int64_t one = 1 << 16;
  const int64_t longer = tolerance == 0 ? 1 : (one + tolerance) * (one + tolerance);
  const Int128 shorter = widened(tolerance == 0 ? 1 : one * one);
  int64_t whole = rounded_up(squared);
  if (whole >= int64_t{1} << 36) {  // far: an error of one part in 2^29 would take many steps
    whole = static_cast<int64_t>(quotient(squared.above, squared.below).low) + 1;
  }
  if (tolerance != 0) {
    whole = static_cast<int64_t>(quotient(shifted_up(widened(whole), 32), widened(longer)).low) + 1;
  }
  while (compare({full_product(whole, longer), shorter}, squared) >= 0) {
    --whole;
  }
  return whole;
}

bool is_nearer(const Triangle& a, const Triangle& b, Fraction& squared,
               Features& features) noexcept {
  if (is_zero(squared.above)) {
    return false;
  }
  if (intersect(a, b)) {
    squared = kZero;
    features = {FeatureKind::intersection, 0, 0};
    return true;
  }
  Search search(squared, features);
  search_all(a, b, search);
  return search.found();
}

bool is_within(const Triangle& a, const Triangle& b, const ShortFraction& squared) noexcept {
  if (intersect(a, b)) {
    return true;
  }
  Search search(squared);
  search_all(a, b, search);
  return search.found();
}

Fraction squared_between(const Triangle& a, const Triangle& b, const Features& features) noexcept {
  const unsigned i = features.of_a;
  const unsigned j = features.of_b;
  const Vector between = difference(b.corner[j], a.corner[i]);
  Fraction squared = kZero;
  // No switch: the proof of the stack bound cannot follow the indirect jump of a jump table.
  const FeatureKind kind = features.kind;
  if (kind == FeatureKind::corners) {
    squared = {widened(dot(between, between)), widened(1)};
  } else if (kind == FeatureKind::corner_edge || kind == FeatureKind::edge_corner) {
    const bool is_of_b = kind == FeatureKind::corner_edge;
    (void)beside<In128>(is_of_b ? edge_of(b, j) : edge_of(a, i),
                        is_of_b ? negated(between) : between, squared);
  } else if (kind == FeatureKind::edges) {
    (void)height_above<In128>(edge_of(a, i), negated(edge_of(b, j)), between, true, squared);
  } else if (kind != FeatureKind::intersection) {
    const bool is_of_b = kind == FeatureKind::corner_face;
    (void)above_face(is_of_b ? a.corner[i] : b.corner[j], is_of_b ? b : a, squared);
  }
  return squared;
}

void nearest_places(const Triangle& a, const Triangle& b, const Features& features,
                    PlaceInTriangle& of_a, PlaceInTriangle& of_b) noexcept {
  const unsigned i = features.of_a;
  const unsigned j = features.of_b;
  const auto at_corner = [](unsigned corner) {
    return PlaceInTriangle{static_cast<uint8_t>(corner), {0, 0}, {0, 0}, {0, 1}};
  };
  // Shares belong to the vectors to the next corner and to the one after it.
  const auto beside = [](const Triangle& t, unsigned corner, const Point& p) {
    const Vector e = edge_of(t, corner);
    return PlaceInTriangle{static_cast<uint8_t>(corner),
                           widened(dot(difference(p, t.corner[corner]), e)),
                           {0, 0},
                           widened(dot(e, e))};
  };
  const auto above = [](const Triangle& t, const Point& p) {
    const Vector e = difference(t.corner[1], t.corner[0]);
    const Vector f = difference(t.corner[2], t.corner[0]);
    const Vector r = difference(p, t.corner[0]);
    const Plane<In128> plane(e, f);
    const int64_t re = dot(r, e);
    const int64_t rf = dot(r, f);
    return PlaceInTriangle{0, plane.first(re, rf), plane.second(re, rf), plane.area()};
  };
  of_a = at_corner(i);
  of_b = at_corner(j);
  const FeatureKind kind = features.kind;
  if (kind == FeatureKind::corner_edge) {
    of_b = beside(b, j, a.corner[i]);
  } else if (kind == FeatureKind::edge_corner) {
    of_a = beside(a, i, b.corner[j]);
  } else if (kind == FeatureKind::corner_face) {
    of_b = above(b, a.corner[i]);
  } else if (kind == FeatureKind::face_corner) {
    of_a = above(a, b.corner[j]);
  } else if (kind == FeatureKind::edges) {
    const Vector e = edge_of(a, i);
    const Vector f = negated(edge_of(b, j));
    const Vector r = difference(b.corner[j], a.corner[i]);
    const Plane<In128> plane(e, f);
    of_a.below = of_b.below = plane.area();
    of_a.first = plane.first(dot(r, e), dot(r, f));
    of_b.first = plane.second(dot(r, e), dot(r, f));
  }
}

}  // namespace flashbvh::detail
