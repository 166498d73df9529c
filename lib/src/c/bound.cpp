// The C interface to bounds.
#include "flashbvh/bound.hpp"
#include "flashbvh/image.hpp"
#include "objects.hpp"

using namespace flashbvh;

namespace {

constexpr flashbvh_run_costs c_costs(const RunCosts& costs) {
  return {costs.start, costs.ascent, costs.later_sibling, costs.leaf_triangle, costs.work};
}

RunCosts costs_of(const flashbvh_run_costs& costs) {
  return {costs.start, costs.ascent, costs.later_sibling, costs.leaf_triangle, costs.work};
}

TreeSize size_of(const flashbvh_tree_size& tree) {
  return {tree.depth, tree.arity, tree.leaf_size, tree.leaf_count, tree.triangle_count};
}

}  // namespace

const flashbvh_run_costs flashbvh_cortex_m0 = c_costs(kCortexM0);
const flashbvh_run_costs flashbvh_cortex_m3 = c_costs(kCortexM3);
const flashbvh_run_costs flashbvh_cortex_m4f = c_costs(kCortexM4F);
const flashbvh_run_costs flashbvh_cortex_m7 = c_costs(kCortexM7);
const flashbvh_run_costs flashbvh_cortex_m33 = c_costs(kCortexM33);
const flashbvh_run_costs flashbvh_cortex_m55 = c_costs(kCortexM55);
const flashbvh_run_costs flashbvh_rv32imac = c_costs(kRV32IMAC);

flashbvh_status flashbvh_image_tree_size(const void* image, size_t size, flashbvh_tree_size* tree) {
  ImageHeader header;
  const Status status = read_image_header(image, size, header);
  if (status == Status::done) {
    const TreeSize found = tree_size_of(header);
    *tree = {found.depth, found.arity, found.leaf_size, found.leaf_count, found.triangle_count};
  }
  return c_status(status);
}

uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return work_within(instructions, costs_of(*costs), size_of(*a), size_of(*b));
}

uint64_t flashbvh_most_instructions(const flashbvh_run_costs* costs, const flashbvh_tree_size* a,
                                    const flashbvh_tree_size* b, uint32_t work) {
  return most_instructions(costs_of(*costs), size_of(*a), size_of(*b), work);
}

uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return most_work(size_of(*a), size_of(*b));
}

uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return largest_step(size_of(*a), size_of(*b));
}
