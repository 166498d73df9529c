// Sizes of lattice boxes for building and ranking trees: integers, the same on every machine.
//
// A box's size is the number of cells that it covers: its extent and one more along each axis. So
// flat and thin boxes, and points, have a size, too.
#pragma once

#include <array>
#include <cstdint>

#include "flashbvh/lattice.hpp"

namespace flashbvh::bake {

/// Cells along each axis; at most 2^15 - 1.
constexpr std::array<std::uint64_t, 3> cells_of(const Box& box) {
  return {static_cast<std::uint64_t>(box.upper.x - box.lower.x + 1),
          static_cast<std::uint64_t>(box.upper.y - box.lower.y + 1),
          static_cast<std::uint64_t>(box.upper.z - box.lower.z + 1)};
}

/// The sum over all three axes; 3 to 2^17.
constexpr std::uint64_t cells_sum(const Box& box) {
  const auto cells = cells_of(box);
  return cells[0] + cells[1] + cells[2];
}

/// Half the surface, in squared cells; 3 to 3 * 2^30.
constexpr std::uint64_t half_surface(const Box& box) {
  const auto cells = cells_of(box);
  return cells[0] * cells[1] + cells[1] * cells[2] + cells[2] * cells[0];
}

/// The number of places in which a cube overlaps the box, times 27. `edges`: the sum of three of
/// the cube's edges, in cells, at most 2^17. Below 2^54.
constexpr std::uint64_t places_of_overlap(const Box& box, std::uint64_t edges) {
  const auto cells = cells_of(box);
  return (3 * cells[0] + edges) * (3 * cells[1] + edges) * (3 * cells[2] + edges);
}

/// The chance that an object that overlaps `parent` also overlaps `child`, a box within it; in
/// parts of kSurely. The object is a cube, whose edge is the mean of the parent's since `ranked`
/// pairs nodes of similar size. All places are equally likely.
constexpr std::uint64_t kSurely = 512;
constexpr std::uint64_t chance_of_overlap(const Box& parent, const Box& child) {
  const std::uint64_t edges = cells_sum(parent);
  return kSurely * places_of_overlap(child, edges) / places_of_overlap(parent, edges);
}

}  // namespace flashbvh::bake
