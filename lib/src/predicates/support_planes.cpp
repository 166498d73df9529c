// Parallel planes through two nearest points: triangles on their outer sides are no nearer.
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "triangle_range.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

/// Components are scaled to kBits, exactly, and kept in two parts.
constexpr int kBits = 54;
constexpr int kLowBits = 26;
constexpr uint32_t kLow = (1u << kLowBits) - 1;

/// Perpendicular part of `way` from the line of an edge, times its squared length: within 2^53.
LongVector from_line(const Vector& edge, const Vector& way) {
  const int64_t length = dot<LongVector>({edge.x, edge.y, edge.z}, edge);
  const int64_t along = dot<LongVector>({way.x, way.y, way.z}, edge);
  return {length * way.x - along * edge.x, length * way.y - along * edge.y,
          length * way.z - along * edge.z};
}

/// Direction between the nearest points, up to its sign and its length. `way`: between corners of
/// the features.
LongVector normal_between(const Triangle& a, const Triangle& b, const Features& features,
                          const Vector& way) {
  // No switch: the proof of the stack bound cannot follow the indirect jump of a jump table.
  const FeatureKind kind = features.kind;
  if (kind == FeatureKind::corners) {
    return {way.x, way.y, way.z};
  }
  if (kind == FeatureKind::corner_edge) {
    return from_line(edge_of(b, features.of_b), way);
  }
  if (kind == FeatureKind::edge_corner) {
    return from_line(edge_of(a, features.of_a), way);
  }
  if (kind == FeatureKind::edges) {
    return cross<LongVector>(edge_of(a, features.of_a), edge_of(b, features.of_b));
  }
  const Triangle& face = kind == FeatureKind::corner_face ? b : a;
  return cross<LongVector>(edge_of(face, 0), edge_of(face, 1));
}

inline int64_t least(int64_t u, int64_t v) {
  return u < v ? u : v;
}
inline int64_t most(int64_t u, int64_t v) {
  return u < v ? v : u;
}

}  // namespace

SupportPlanes::SupportPlanes(const Triangle& a, const Triangle& b,
                             const Features& features) noexcept
    : is_any_(true) {
  const Point& on_a = a.corner[features.of_a];
  const Point& on_b = b.corner[features.of_b];
  const LongVector n = normal_between(a, b, features, difference(on_b, on_a));
  const auto bits = [](int64_t v) { return static_cast<uint64_t>(v < 0 ? ~v : v); };
  const int up = __builtin_clzll(bits(n.x) | bits(n.y) | bits(n.z) | 1) - (64 - kBits);
  set_normal(n.x, n.y, n.z, int64_t{1} << up);
  if (along(on_b, on_a) < Along{0, 0}) {
    set_normal(n.x, n.y, n.z, -(int64_t{1} << up));
  }
  const Along apart = along(on_b, on_a);
  high_apart_ = apart.high;
  low_apart_ = apart.low;
}

void SupportPlanes::set_normal(int64_t x, int64_t y, int64_t z, int64_t scale) noexcept {
  const int64_t component[3] = {x * scale, y * scale, z * scale};
  for (int i = 0; i < 3; ++i) {
    high_[i] = static_cast<int32_t>(component[i] >> kLowBits);
    low_[i] = static_cast<uint32_t>(component[i]) & kLow;
  }
  rest_ = (low_[0] | low_[1] | low_[2]) != 0 ? kRest : uint16_t{0};
}

SupportPlanes::Along SupportPlanes::along(const Point& to, const Point& from) const noexcept {
  const Vector way = difference(to, from);
  const int64_t below =
      int64_t{low_[0]} * way.x + int64_t{low_[1]} * way.y + int64_t{low_[2]} * way.z;
  return {high_along(to, from) + (below >> kLowBits), static_cast<uint32_t>(below) & kLow};
}

bool SupportPlanes::separates(const Triangle& a, const Triangle& b) const noexcept {
  if (!is_any_) {
    return false;
  }
  // The high parts decide, except within `rest`, the most that the low parts can add.
  const int64_t rest = uint32_t{rest_} << 16;
  const Point& from = a.corner[0];
  const int64_t of_b = least(least(high_along(b.corner[0], from), high_along(b.corner[1], from)),
                             high_along(b.corner[2], from));
  const int64_t of_a = most(most(0, high_along(a.corner[1], from)), high_along(a.corner[2], from));
  const int64_t left = of_b - of_a - high_apart_;
  return left > rest || (left >= -rest && (rest == 0 || separates_exactly(a, b)));
}

bool SupportPlanes::separates_exactly(const Triangle& a, const Triangle& b) const noexcept {
  const auto nearer = [](const Along& u, const Along& v) { return v < u ? v : u; };
  const Point& from = a.corner[0];
  const Along of_b =
      nearer(nearer(along(b.corner[0], from), along(b.corner[1], from)), along(b.corner[2], from));
  // Whether B lies at least the distance of the planes beyond a corner of A.
  const auto is_beyond = [&](const Along& of_a) {
    const uint32_t low = of_a.low + low_apart_;
    return !(of_b < Along{of_a.high + high_apart_ + (low >> kLowBits), low & kLow});
  };
  return is_beyond({0, 0}) && is_beyond(along(a.corner[1], from)) &&
         is_beyond(along(a.corner[2], from));
}

PackedVector SupportPlanes::direction() const noexcept {
  if (!is_any_) {
    return {0, 0};
  }
  const auto leading = [&](int i) { return high_[i] >> (kBits - kLowBits - 13); };
  return {join_halves(static_cast<uint16_t>(leading(0)), static_cast<uint16_t>(leading(1))),
          leading(2)};
}

}  // namespace flashbvh::detail
