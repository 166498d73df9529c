// The exact test as queries call it, on triangles that a walk brings together.
#include "flashbvh/detail/predicates/triangle.hpp"
#include "support/test.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh::detail;

namespace {

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
  std::uint32_t tested = 0;
  std::uint32_t intersect = 0;
  const auto tries = rounds(12000u, 60000u);
  for_rounds(tries, 8, [&](Random& random, std::uint32_t) {
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
  });
  CHECK(tested > tries / 3);
  CHECK(intersect > tries / 12);
}

TEST_CASE("a box and a triangle overlap where their bounds do") {
  std::uint32_t overlapping = 0;
  const auto tries = rounds(12000u, 60000u);
  for_rounds(tries, 9, [&](Random& random, std::uint32_t round) {
    const int size = round % 3 == 0 ? 3 : round % 3 == 1 ? 300 : kMaxCoordinate;
    const Vertex u = any_vertex(random, size);
    const Box box = box_around(u, any_vertex(random, size));
    Point shift = {0, 0, 0};
    for (const auto axis : kPointAxes) {
      shift.*axis = random.below(4) == 0 ? random.between(-80000, 80000) : 0;
    }
    const Triangle t = shifted(any_triangle(random, size), shift);
    bool expected = true;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = [&](int corner) { return t.corner[corner].*kPointAxes[axis]; };
      const auto [least, most] = std::minmax({at(0), at(1), at(2)});
      expected =
          expected && least <= box.upper.*kVertexAxes[axis] && most >= box.lower.*kVertexAxes[axis];
    }
    REQUIRE(box_overlaps(pack(box), t) == expected);
    overlapping += expected ? 1 : 0;
  });
  CHECK(overlapping > tries / 12);
  CHECK(overlapping < tries - tries / 12);
}
