// What a mesh takes that bends (flashbvh/deformable.hpp).
#ifndef FLASHBVH_TOOLS_CLI_BENDING_HPP
#define FLASHBVH_TOOLS_CLI_BENDING_HPP

#include <cstddef>

namespace flashbvh::tool {

struct BendingCost {
  std::size_t ram_bytes;           ///< nodes and vertices
  std::size_t refit_instructions;  ///< of all of it, on a Cortex-M4F at -O2, within 12 %
};

/// `index_bits`: 16 or 32. The instructions are those that tests/budget/refit_cost_test.cpp holds
/// to.
constexpr BendingCost bending_cost(std::size_t nodes, std::size_t triangles, std::size_t vertices,
                                   unsigned index_bits) {
  const std::size_t node_bytes = index_bits == 32 ? 20 : 16;
  return {nodes * node_bytes + vertices * 6, 48 * triangles + 12 * nodes};
}

}  // namespace flashbvh::tool

#endif
