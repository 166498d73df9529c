// Triangles placed to 1/16 cell.
#include "fine_pair.hpp"

#include "../predicates/triangle_range.hpp"
#include "flashbvh/detail/query/proximity.hpp"

namespace flashbvh::detail {
namespace {

constexpr uint8_t kFinestBits = 4;
/// sqrt(3) / 2 in 1/256: the most that rounding moves a point, in units of the grid.
constexpr uint32_t kPlacingSteps = 222;

/// Largest difference of two corners' coordinates along an axis.
uint32_t span_along(const FinePair& pair, int32_t Point::*axis) {
  const Range a = range_of(pair.a, axis);
  const Range b = range_of(pair.b, axis);
  const int32_t least = a.least < b.least ? a.least : b.least;
  const int32_t most = a.most > b.most ? a.most : b.most;
  return static_cast<uint32_t>(most) - static_cast<uint32_t>(least);
}
bool is_fine(const FinePair& pair) {
  constexpr uint32_t most = kMaxApart;
  return span_along(pair, &Point::x) <= most && span_along(pair, &Point::y) <= most &&
         span_along(pair, &Point::z) <= most;
}

/// Fraction bits of the grid: a share of the reach suffices, and small numbers multiply in fewer
/// words. Keeps is_apart() in range for `distance`.
uint8_t bits_for(uint32_t distance, uint32_t within) {
  const uint32_t reach = distance - within;
  const uint8_t bits = reach < 2 * kFineOne ? kFinestBits : reach < 16 * kFineOne ? 2 : 0;
  return bits > 2 && distance >= kCoarseDistance / 4 ? 2 : bits;
}

/// Rounds `at`, which has 30 fraction bits, to the nearest 2^-bits cell.
int32_t rounded_to(int64_t at, unsigned bits) {
  return static_cast<int32_t>((at + (int64_t{1} << (29 - bits))) >> (30 - bits));
}

}  // namespace

template <class Mesh>
void set_fine_pair(const Mesh& a, uint32_t of_a, const Mesh& b, uint32_t of_b, const Frame& frame,
                   uint32_t distance, uint32_t within, FinePair& pair) {
  const auto* const corners_a = a.triangles[of_a].corner;
  const Vertex& first = a.vertices[corners_a[0]];
  const int32_t base[3] = {a.origin[0] + first.x, a.origin[1] + first.y, a.origin[2] + first.z};
  pair.bits = bits_for(distance, within);
  for (;;) {
    const unsigned bits = pair.bits;
    for (int i = 0; i < 3; ++i) {
      const Vertex& of_first = a.vertices[corners_a[i]];
      pair.a.corner[i] = {(of_first.x - first.x) * (1 << bits),
                          (of_first.y - first.y) * (1 << bits),
                          (of_first.z - first.z) * (1 << bits)};
      const Vertex& v = b.vertices[b.triangles[of_b].corner[i]];
      const int64_t x = int64_t{b.origin[0]} + v.x;
      const int64_t y = int64_t{b.origin[1]} + v.y;
      const int64_t z = int64_t{b.origin[2]} + v.z;
      int32_t placed[3];
      for (int axis = 0; axis < 3; ++axis) {
        const auto& row = frame.rotation[axis];
        placed[axis] = rounded_to(row[0] * x + row[1] * y + row[2] * z +
                                      int64_t{frame.translation[axis]} * (1 << (30 - kFrameBits)) -
                                      int64_t{base[axis]} * (1 << 30),
                                  bits);
      }
      pair.b.corner[i] = {placed[0], placed[1], placed[2]};
    }
    if (bits == 0 || is_fine(pair)) {
      return;
    }
    --pair.bits;
  }
}

bool is_apart(const FinePair& pair, uint32_t distance) {
  if (distance >= kCoarseDistance) {
    return false;
  }
  const uint64_t steps = (distance << pair.bits) + kPlacingSteps;
  const auto limit = static_cast<int64_t>(steps * steps / Within::kStepsSquared);
  Direction direction;
  return boxes_separate(pair.a, pair.b, limit, direction) ||
         directions_separate(pair.a, pair.b, limit, direction) ||
         planes_separate(pair.a, pair.b, limit) ||
         edges_separate(pair.a, pair.b, limit, direction) ||
         !is_within(pair.a, pair.b, {steps * steps, Within::kStepsSquared});
}

PackedVector direction_between(const FinePair& pair) {
  if (!is_fine(pair)) {
    return {0, 0};
  }
  Fraction squared = kInfinite;
  Features features = {FeatureKind::intersection, 0, 0};
  (void)is_nearer(pair.a, pair.b, squared, features);
  return features.kind == FeatureKind::intersection
             ? PackedVector{0, 0}
             : SupportPlanes(pair.a, pair.b, features).direction();
}

bool has_near_corners(const FinePair& pair, uint32_t distance) {
  const uint64_t most = uint64_t{distance} * distance;  // in 1/65,536 square cell
  for (const Point& p : pair.a.corner) {
    for (const Point& q : pair.b.corner) {
      const int64_t x = int64_t{p.x} - q.x;
      const int64_t y = int64_t{p.y} - q.y;
      const int64_t z = int64_t{p.z} - q.z;
      // x, y, z are up to 2^25. `most` has 16 fraction bits, the squares have 2 * bits.
      if (static_cast<uint64_t>(x * x + y * y + z * z) <= most >> (16 - 2 * pair.bits)) {
        return true;
      }
    }
  }
  return false;
}

template void set_fine_pair(const Mesh&, uint32_t, const Mesh&, uint32_t, const Frame&, uint32_t,
                            uint32_t, FinePair&);
template void set_fine_pair(const Mesh32&, uint32_t, const Mesh32&, uint32_t, const Frame&,
                            uint32_t, uint32_t, FinePair&);

}  // namespace flashbvh::detail
