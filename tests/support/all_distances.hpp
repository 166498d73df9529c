// The distances of all pairs of triangles of two meshes, by brute force.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "support/transformed_vertex.hpp"

namespace flashbvh::test {

struct Pairwise {
  detail::Fraction squared;
  std::uint16_t of_a;  ///< slots
  std::uint16_t of_b;
  std::uint32_t id_a;
  std::uint32_t id_b;
};

/// The distances of all pairs of triangles, by slot in A, then in B.
inline std::vector<Pairwise> all_distances(const Mesh& a, const Mesh& b, const Pose& pose) {
  std::vector<Pairwise> all;
  for_all_pairs(
      a, b, pose,
      [&](std::uint32_t i, std::uint32_t j, const Triangle& of_a, const Triangle& of_b) {
        detail::Fraction squared = detail::kInfinite;
        detail::Features features{};
        REQUIRE(detail::is_nearer(of_a, of_b, squared, features));
        all.push_back({squared, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                       a.triangle_ids[i], b.triangle_ids[j]});
      });
  return all;
}

inline const Pairwise& least_of(const std::vector<Pairwise>& all) {
  return *std::min_element(all.begin(), all.end(), [](const Pairwise& p, const Pairwise& q) {
    return detail::compare(p.squared, q.squared) < 0;
  });
}

/// The square root, in cells, to the last bits of a double.
inline double length_of(const detail::Fraction& squared) {
  const auto number = [](const detail::Int128& u) {
    return std::ldexp(static_cast<double>(u.high), 64) + static_cast<double>(u.low);
  };
  return std::sqrt(number(squared.above) / number(squared.below));
}

}  // namespace flashbvh::test
