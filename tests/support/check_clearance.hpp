// Checks the points and direction of a distance, and the pairs within a distance, by known pairs.
#pragma once

#include <catch2/catch.hpp>

#include <cstdint>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "support/any_mesh.hpp"
#include "support/vectors.hpp"

namespace flashbvh::test {

/// Checks that the points are as far apart as reported, but for their rounding, and that the
/// direction leads from one to the other.
inline void check_points(const Clearance<std::uint16_t>& found) {
  const FloatVector way = minus(vector_of<double>(found.point_b), vector_of<double>(found.point_a));
  const double apart = length_of(way);
  REQUIRE(apart <= found.upper + 1.8);
  REQUIRE(apart >= found.lower - 1.8);
  if (found.lower != 0) {
    const FloatVector direction = times(1.0 / kUnitOne, vector_of<double>(found.direction));
    REQUIRE(std::abs(length_of(direction) - 1) < 4e-9);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      REQUIRE(std::abs(direction[axis] * apart - way[axis]) <= 2);
    }
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
  truth = sorted(truth);
  for (const std::uint32_t work : works) {
    WithinQuery query(a, b, pose, {}, within({reach}));
    REQUIRE(sorted(run_to_end(query, work, 5)) == truth);
  }
  const Answer answer = closer_than(a, b, pose, {reach});
  REQUIRE(answer.status == Status::done);
  REQUIRE(answer.yes == !truth.empty());
}

}  // namespace flashbvh::test
