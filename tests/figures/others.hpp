// Meshes other than robots, pair by pair, as callers query them: from the pose to the result.
#pragma once

#include "measure.hpp"
#include "query_pose.hpp"

namespace figures {

/// Calls `add(names, pair, query_pose)` for each pose in turn. Returns main()'s status: 1 if a call
/// returns false. `set`: the name of the digest's set.
template <class Add>
int measure_others(const char* set, const Add& add) {
  constexpr bool kRotated[] = {false, true};
  bool right = true;
  for (uint32_t p = 0; p < kMeshPairCount; ++p) {
    const MeshPair& pair = kMeshPairs[p];
    for (const bool rotated : kRotated) {
      for (uint32_t i = 0; i < kProximities; ++i) {
        const FigureNames names = {pair.a_name, rotated ? "rotated" : "translated",
                                   kProximityNames[i]};
        for (const QueryPose& query_pose : (rotated ? pair.rotated : pair.translated)[i]) {
          right = add(names, pair, query_pose) && right;
        }
      }
    }
    print_rows();
  }
  return print_all(set, right);
}

}  // namespace figures
