// All that firmware links for one exact query under any rigid pose: made, run in slices, resumed.
#include "flashbvh/query.hpp"

extern "C" uint32_t entry(const flashbvh::PostTree& a, const flashbvh::PostTree& b,
                          const flashbvh::Pose& pose, flashbvh::PairQuery::Pair* found) {
  flashbvh::PairQuery query(a, b, pose);
  uint32_t count = 0;
  while (query.status() == flashbvh::Status::suspended) {
    count += query.run(100, found, 8).count;
  }
  return count;
}
