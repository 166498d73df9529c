// Checks the points and direction of a distance, and the pairs within a distance, by known pairs.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "support/any_mesh.hpp"

namespace flashbvh::test {

/// Checks that the points are as far apart as reported, but for their rounding, and that the
/// direction leads from one to the other.
inline void check_points(const Clearance<std::uint16_t>& found) {
  const double x = static_cast<double>(found.point_b.x - found.point_a.x);
  const double y = static_cast<double>(found.point_b.y - found.point_a.y);
  const double z = static_cast<double>(found.point_b.z - found.point_a.z);
  const double apart = std::sqrt(x * x + y * y + z * z);
  REQUIRE(apart <= found.upper + 1.8);
  REQUIRE(apart >= found.lower - 1.8);
  if (found.lower != 0) {
    const double scale = 1.0 / kUnitOne;
    const double length = std::sqrt(scale * found.direction.x * scale * found.direction.x +
                                    scale * found.direction.y * scale * found.direction.y +
                                    scale * found.direction.z * scale * found.direction.z);
    REQUIRE(std::abs(length - 1) < 4e-9);
    REQUIRE(std::abs(found.direction.x * scale * apart - x) <= 2);
    REQUIRE(std::abs(found.direction.y * scale * apart - y) <= 2);
    REQUIRE(std::abs(found.direction.z * scale * apart - z) <= 2);
  } else {
    REQUIRE((found.upper != 0 || (found.direction.x | found.direction.y | found.direction.z) == 0));
  }
}

/// Checks that the pairs within `reach` are those of `all` with `is_within(pair)`, by their ids, in
/// runs of each budget of `works`.
template <class KnownPair, class IsWithin>
void check_pairs_within(const std::vector<KnownPair>& all, const IsWithin& is_within, const Mesh& a,
                        const Mesh& b, const Pose& pose, std::uint32_t reach,
                        const std::vector<std::uint32_t>& works) {
  CAPTURE(reach);
  Pairs truth;
  for (const KnownPair& pair : all) {
    if (is_within(pair)) {
      truth.emplace_back(pair.id_a, pair.id_b);
    }
  }
  std::sort(truth.begin(), truth.end());
  for (const std::uint32_t work : works) {
    WithinQuery query(a, b, pose, {}, within(reach));
    Pairs pairs = run_to_end(query, work, 5);
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs == truth);
  }
  const Answer answer = closer_than(a, b, pose, reach);
  REQUIRE(answer.status == Status::done);
  REQUIRE(answer.yes == !truth.empty());
}

}  // namespace flashbvh::test
