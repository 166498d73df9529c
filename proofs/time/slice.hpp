// What is analysed and measured: making a query, one run of it, and of a mesh against itself.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "flashbvh/self.hpp"

namespace bound {

constexpr uint32_t kCapacity = 16;

struct Slice {
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
  const flashbvh::Pose* pose;
  flashbvh::PairQuery* query;
  flashbvh::SelfQuery* itself;
  uint32_t work;
  flashbvh::PairQuery::Pair found[kCapacity];
  flashbvh::RunResult step;
};

}  // namespace bound

// In a file of their own, to be neither inlined nor made for one use. `slice`: a bound::Slice.
extern "C" {
void bound_make_query(void* slice);
void bound_run(void* slice);
void bound_run_itself(void* slice);
void bound_done();  ///< after each of these: what follows is not looked at
}
