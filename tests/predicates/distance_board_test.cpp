// Separation tests of triangles in 32 bits against 64 bits, at a query's largest distance.
#include <stdint.h>

#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "support/points.hpp"
#include "support/rounds.hpp"

namespace flashbvh::test {
namespace {

/// Slightly more than twice the largest distance of a mesh's corners along an axis.
constexpr int32_t kFarthest = 70000;

int64_t dot(const int64_t (&direction)[3], const Point& p) {
  return direction[0] * p.x + direction[1] * p.y + direction[2] * p.z;
}

/// The definition: the direction between the middles, of 12 bits per component.
bool middles_separate_in_64_bits(const Triangle& a, const Triangle& b) {
  int64_t d[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    d[0] += b.corner[i].x - a.corner[i].x;
    d[1] += b.corner[i].y - a.corner[i].y;
    d[2] += b.corner[i].z - a.corner[i].z;
  }
  const auto size = [](int64_t value) { return value < 0 ? -value : value; };
  while (((size(d[0]) | size(d[1]) | size(d[2])) >> 12) != 0) {
    for (int64_t& component : d) {
      component >>= 1;
    }
  }
  int64_t most = INT64_MIN;
  int64_t least = INT64_MAX;
  for (int i = 0; i < 3; ++i) {
    most = dot(d, a.corner[i]) > most ? dot(d, a.corner[i]) : most;
    least = dot(d, b.corner[i]) < least ? dot(d, b.corner[i]) : least;
  }
  return most < least;
}

}  // namespace

TEST_CASE("separated triangles are detected in 32 bits as in 64, on every core") {
  Random random(5);
  uint32_t sum = 2166136261u;
  uint32_t separated = 0;
  for (int round = 0; round < 4000; ++round) {
    const int32_t size = 1 << random.below(15);
    const int32_t far = round % 4 != 0 ? 2 * size : kFarthest;
    const Triangle a = any_triangle(random, size);
    const Point at = any_point(random, far);
    const Triangle b = shifted(any_triangle(random, size), at);
    const bool by_middles = detail::middles_separate(a, b);
    CAPTURE(round);
    REQUIRE(by_middles == middles_separate_in_64_bits(a, b));
    detail::Direction first;
    const bool by_directions = detail::directions_separate(a, b, 0, first);
    separated += by_middles ? 1 : 0;
    sum = (sum ^ (by_directions ? 1u : 0u) ^ first.packed) * 16777619u;
  }
  CHECK(separated > 1000);
  CHECK(sum == 0x132BB45Au);
}

}  // namespace flashbvh::test
