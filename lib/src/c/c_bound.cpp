// The C interface to time bounds.
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "objects.hpp"

using namespace flashbvh;

const flashbvh_run_costs flashbvh_cortex_m0 = kCortexM0;
const flashbvh_run_costs flashbvh_cortex_m3 = kCortexM3;
const flashbvh_run_costs flashbvh_cortex_m4f = kCortexM4F;
const flashbvh_run_costs flashbvh_cortex_m7 = kCortexM7;
const flashbvh_run_costs flashbvh_cortex_m33 = kCortexM33;
const flashbvh_run_costs flashbvh_cortex_m55 = kCortexM55;
const flashbvh_run_costs flashbvh_rv32imac = kRV32IMAC;

flashbvh_status flashbvh_image_tree_size(const void* image, size_t size, flashbvh_tree_size* tree) {
  ImageHeader header;
  const Status status = read_image_header(image, size, header);
  if (status == Status::done) {
    *tree = tree_size_of(header);
  }
  return c_status(status);
}

uint32_t flashbvh_work_within(uint64_t instructions, const flashbvh_run_costs* costs,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return work_within(instructions, *costs, *a, *b);
}

uint64_t flashbvh_most_instructions(const flashbvh_run_costs* costs, const flashbvh_tree_size* a,
                                    const flashbvh_tree_size* b, uint32_t work) {
  return most_instructions(*costs, *a, *b, work);
}

uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return most_work(*a, *b);
}

uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return largest_step(*a, *b);
}
