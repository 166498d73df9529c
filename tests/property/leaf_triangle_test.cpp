// The exact test as queries ask it, of triangles that a walk brought together.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "flashbvh/detail/triangle.hpp"
#include "support/random.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr std::int16_t Vertex::*kVertexAxes[3] = {&Vertex::x, &Vertex::y, &Vertex::z};

/// Whether no edge is longer than 2^15 - 1 cells along an axis.
bool is_narrow(const Triangle& t) {
  for (const auto axis : kPointAxes) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(t.corner[i].*axis - t.corner[(i + 1) % 3].*axis) > 32767) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("narrow triangles intersect where triangles do") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 8);
  std::uint32_t tested = 0;
  std::uint32_t intersect = 0;
  const auto tries = rounds(12000u, 60000u);
  for (std::uint32_t round = 0; round < tries; ++round) {
    CAPTURE(round);
    const TransformedPair pair = any_pair(random);
    const bool expected = triangles_intersect(pair.a, pair.b);
    REQUIRE(wide_triangles_intersect(pair.a, pair.b) == expected);
    if (is_narrow(pair.a) && is_narrow(pair.b)) {
      PlaneNormal normal;
      get_near_normal(pair.b, normal);
      REQUIRE(near_triangles_intersect(pair.a, pair.b, normal) == expected);
      ++tested;
      intersect += expected ? 1 : 0;
    }
  }
  CHECK(tested > tries / 3);
  CHECK(intersect > tries / 12);
}

TEST_CASE("a box and a triangle overlap where their bounds do") {
  const std::uint64_t seed = test_seed();
  CAPTURE(seed);
  Random random(seed + 9);
  std::uint32_t overlapping = 0;
  const auto tries = rounds(12000u, 60000u);
  for (std::uint32_t round = 0; round < tries; ++round) {
    CAPTURE(round);
    const int size = round % 3 == 0 ? 3 : round % 3 == 1 ? 300 : kMaxCoordinate;
    const auto at = [&] { return static_cast<std::int16_t>(random.between(-size, size)); };
    Box box;
    Triangle t;
    bool expected = true;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int16_t u = at();
      const std::int16_t v = at();
      box.lower.*kVertexAxes[axis] = std::min(u, v);
      box.upper.*kVertexAxes[axis] = std::max(u, v);
      std::int32_t least = INT32_MAX;
      std::int32_t most = INT32_MIN;
      const std::int32_t shift = random.below(4) == 0 ? random.between(-80000, 80000) : 0;
      for (Point& corner : t.corner) {
        corner.*kPointAxes[axis] = at() + shift;
        least = std::min(least, corner.*kPointAxes[axis]);
        most = std::max(most, corner.*kPointAxes[axis]);
      }
      expected =
          expected && least <= box.upper.*kVertexAxes[axis] && most >= box.lower.*kVertexAxes[axis];
    }
    REQUIRE(box_overlaps(pack(box), t) == expected);
    overlapping += expected ? 1 : 0;
  }
  CHECK(overlapping > tries / 12);
  CHECK(overlapping < tries - tries / 12);
}
