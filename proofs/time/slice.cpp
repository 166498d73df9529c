#include "slice.hpp"

void bound_make_query(void* context) {
  auto& slice = *static_cast<bound::Slice*>(context);
  flashbvh::PairQuery query(*slice.a, *slice.b, *slice.pose);
  flashbvh::detail::keep_in_memory(query);
}

void bound_run(void* context) {
  auto& slice = *static_cast<bound::Slice*>(context);
  slice.step = slice.query->run(slice.work, slice.found);
}

void bound_run_itself(void* context) {
  auto& slice = *static_cast<bound::Slice*>(context);
  slice.step = slice.itself->run(slice.work, slice.found);
}

void bound_done() {
  __asm__ volatile("");
}
