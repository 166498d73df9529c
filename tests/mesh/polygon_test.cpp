// Triangulated polygons: equal to applying the rule to every corner each time.
#include "mesh/polygon.hpp"
#include "support/test.hpp"

using tool::Corner2;
using Corner3 = std::array<double, 3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

namespace {

bool is_ear(const std::vector<Corner3>& corners, const std::vector<std::uint32_t>& left,
            std::size_t at) {
  const auto flat = [&](std::size_t i) {
    const Corner3& corner = corners[left[i % left.size()]];
    return Corner2{corner[0], corner[1]};
  };
  const Corner2 p = flat(at + left.size() - 1);
  const Corner2 q = flat(at);
  const Corner2 r = flat(at + 1);
  bool ear = tool::turn(p, q, r) > 0;
  for (std::size_t i = 0; ear && i < left.size(); ++i) {
    const Corner2 other = flat(i);
    ear = other == p || other == q || other == r || tool::turn(p, q, other) < 0 ||
          tool::turn(q, r, other) < 0 || tool::turn(r, p, other) < 0;
  }
  return ear;
}

/// Cuts the first ear from the second corner on, with the first corner last; the second corner if
/// there is none. For counter-clockwise polygons in the plane z = 0.
Triangles triangulate_slowly(const std::vector<Corner3>& corners) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    left.push_back(i);
  }
  Triangles triangles;
  while (left.size() > 3) {
    std::size_t ear = 1;
    while (ear < left.size() && !is_ear(corners, left, ear)) {
      ++ear;
    }
    ear = ear < left.size() ? ear : is_ear(corners, left, 0) ? 0 : 1;
    triangles.push_back(
        {left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

double twice_area(const std::vector<Corner3>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner3& p = corners[i];
    const Corner3& q = corners[(i + 1) % corners.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area;
}

}  // namespace

TEST_CASE("polygons, simple or crossing, are cut as by testing every corner each time") {
  for_rounds(4000, [&](Random& random, int i) {
    const std::uint32_t count = 3 + random.below(i % 40 == 0 ? 60 : 12);
    const std::uint32_t kind = random.below(3);
    std::vector<Corner3> corners;
    for (std::uint32_t corner = 0; corner < count; ++corner) {
      const double turn = 6.283185307 * corner / count;
      const double radius = kind == 0 ? 1 : 1 + random.below(100) / 30.0;
      corners.push_back(kind == 2 ? Corner3{double(random.below(5)), double(random.below(5)), 0}
                                  : Corner3{radius * std::cos(turn), radius * std::sin(turn), 0});
    }
    const double area = twice_area(corners);
    if (area < 0) {
      std::reverse(corners.begin(), corners.end());
    } else if (!(area > 0)) {
      return;  // has no front side
    }
    CAPTURE(kind, count);
    REQUIRE(tool::triangulate(corners) == triangulate_slowly(corners));
  });
}

TEST_CASE("a comb of many corners is cut into triangles that cover it") {
  constexpr int kTeeth = 2000;
  std::vector<Corner3> comb;
  for (int i = 0; i < kTeeth; ++i) {
    comb.push_back({double(i), 0, 0});
  }
  for (int i = kTeeth - 1; i >= 0; --i) {
    comb.push_back({double(i), i % 2 == 0 ? 1.0 : 10.0, 0});
  }
  const Triangles triangles = tool::triangulate(comb);
  REQUIRE(triangles.size() == comb.size() - 2);
  double area = 0;
  bool all_forward = true;
  for (const auto& [a, b, c] : triangles) {
    const double part = twice_area({comb[a], comb[b], comb[c]});
    all_forward = all_forward && part > 0;
    area += part;
  }
  CHECK(all_forward);
  CHECK(area == twice_area(comb));
}
