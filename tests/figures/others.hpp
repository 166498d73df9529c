// Meshes other than robots, pair by pair, as callers query them: from the pose to the result.
#pragma once

#include "measure.hpp"
#include "query_pose.hpp"

namespace figures {

/// Calls `measure_pose` for each pose in turn (for_each_query_pose()). Returns main()'s status: 1
/// if a call returns false. `set`: the name of the digest's set.
template <class Call>
int measure_others(const char* set, const Call& measure_pose) {
  bool right = true;
  for (uint32_t p = 0; p < kMeshPairCount; ++p) {
    right = for_each_query_pose(measure_pose, kMeshPairs + p, 1) && right;
    print_rows();
  }
  return print_all(set, right);
}

}  // namespace figures
