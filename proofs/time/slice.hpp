// The analysed and measured code: making a query, one run of it, and one against itself.
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

// In a separate file, so that they are neither inlined nor specialised. `slice`: a bound::Slice.
extern "C" {
void bound_make_query(void* slice);
void bound_run(void* slice);
void bound_run_itself(void* slice);
void bound_done();  ///< ends each of these; the analysis ignores later code
}
