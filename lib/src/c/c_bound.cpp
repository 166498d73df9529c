// The C interface to time bounds.
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "objects.hpp"

using namespace flashbvh;

#define FLASHBVH_CONSTANT(core, c_name, ...) const flashbvh_run_costs flashbvh_##c_name = k##core;
FLASHBVH_FOR_EACH_CORE(FLASHBVH_CONSTANT)
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
