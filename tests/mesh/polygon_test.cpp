// Polygons cut into triangles.
#include "mesh/polygon.hpp"
#include "support/test.hpp"

using Corner3 = std::array<double, 3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

namespace {

double twice_area(const std::vector<Corner3>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner3& p = corners[i];
    const Corner3& q = corners[(i + 1) % corners.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area;
}

/// Each of the triangles runs forward, and together they have the polygon's area.
void check_cover(const std::vector<Corner3>& corners) {
  double area = 0;
  bool all_forward = true;
  for (const auto& [a, b, c] : tool::triangulate(corners)) {
    const double part = twice_area({corners[a], corners[b], corners[c]});
    all_forward = all_forward && part > 0;
    area += part;
  }
  REQUIRE(all_forward);
  REQUIRE(area == Approx(twice_area(corners)));
}

}  // namespace

TEST_CASE("a polygon is cut into triangles that cover it; one that crosses itself has as many") {
  for_rounds(4000, [&](Random& random, int i) {
    const std::uint32_t count = 3 + random.below(i % 40 == 0 ? 60 : 12);
    const bool is_crossing = random.below(3) == 0;
    std::vector<Corner3> corners;
    for (std::uint32_t corner = 0; corner < count; ++corner) {
      const double turn = 6.283185307 * corner / count;
      const double radius = 1 + random.below(100) / 30.0;
      const double x = random.below(5);
      corners.push_back(is_crossing ? Corner3{x, double(random.below(5)), 0}
                                    : Corner3{radius * std::cos(turn), radius * std::sin(turn), 0});
    }
    CAPTURE(is_crossing, count);
    const Triangles triangles = tool::triangulate(corners);
    REQUIRE(triangles.size() == count - 2);
    if (!is_crossing && count > 4) {  // round the middle
      check_cover(corners);
    }
  });
}

TEST_CASE("a convex polygon is a fan from its first corner, in any plane, in either direction") {
  const std::vector<Corner3> corners = {{0, 0, 5}, {0, 4, 7}, {0, 5, 9}, {0, 1, 8}};
  const std::vector<Corner3> turned = {{0, 0, 5}, {0, 1, 8}, {0, 5, 9}, {0, 4, 7}};
  const Triangles fan = {{0, 1, 2}, {0, 2, 3}};
  CHECK(tool::triangulate(corners) == fan);
  CHECK(tool::triangulate(turned) == fan);
}

TEST_CASE("a comb of many corners is cut into triangles that cover it") {
  constexpr int kTeeth = 500;
  std::vector<Corner3> comb;
  for (int i = 0; i < kTeeth; ++i) {
    comb.push_back({double(i), 0, 0});
  }
  for (int i = kTeeth - 1; i >= 0; --i) {
    comb.push_back({double(i), i % 2 == 0 ? 1.0 : 10.0, 0});
  }
  check_cover(comb);
}
