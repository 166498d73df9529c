// The C interface to time bounds.
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "objects.hpp"

using namespace flashbvh;

#define FLASHBVH_CONSTANT(core, c_name, ...) const flashbvh_run_costs flashbvh_##c_name = k##core;
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT
#define FLASHBVH_CONSTANT(core, c_name, ...) \
  const flashbvh_run_cycles flashbvh_##c_name##_cycles = k##core##Cycles;
FLASHBVH_FOR_EACH_CORE_IN_CYCLES(FLASHBVH_CONSTANT)
#undef FLASHBVH_CONSTANT

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

uint32_t flashbvh_work_within_cycles(uint64_t cycles, const flashbvh_run_cycles* core,
                                     uint32_t wait_states, const flashbvh_tree_size* a,
                                     const flashbvh_tree_size* b) {
  return work_within(cycles, *core, wait_states, *a, *b);
}

uint64_t flashbvh_most_cycles(const flashbvh_run_cycles* core, uint32_t wait_states,
                              const flashbvh_tree_size* a, const flashbvh_tree_size* b,
                              uint32_t work) {
  return most_cycles(*core, wait_states, *a, *b, work);
}

uint64_t flashbvh_most_work(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return most_work(*a, *b);
}

uint64_t flashbvh_largest_step(const flashbvh_tree_size* a, const flashbvh_tree_size* b) {
  return largest_step(*a, *b);
}
