// The links of a KUKA KR5, pair by pair, and the poses of their queries: lib/docs/figures.md.
#pragma once

#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace figures {

/// The proximity of two meshes, as in the paper's section 9.1.
enum class Proximity : uint8_t {
  separated,     ///< the boxes of the roots are disjoint: one visit decides
  close,         ///< more than 10 pairs of leaves overlap, no triangles intersect
  intersecting,  ///< triangles intersect
};

constexpr const char* kProximityNames[] = {"separated", "close", "intersecting"};
constexpr uint32_t kProximities = 3;
constexpr uint32_t kPosesOfPair = 16;  ///< of a class

/// Two links without a common joint.
struct LinkPair {
  const char* a_name;
  const char* b_name;
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
};
constexpr uint32_t kLinkPairs = 4;
extern const LinkPair kPairs[kLinkPairs];

/// A pose of a pair and class, or the pose `along_x` cells further.
struct PoseKey {
  bool rotated;
  Proximity proximity;
  uint32_t pair;
  uint32_t number;  ///< below kPosesOfPair

  const char* motion() const { return rotated ? "rotated" : "translated"; }
  const char* proximity_name() const { return kProximityNames[static_cast<uint32_t>(proximity)]; }
  flashbvh::Pose pose(int32_t along_x = 0) const;
};

/// Calls `call(pair, key)` for each pose. Returns whether all calls return true.
template <class Call>
bool for_each_pose(const Call& call) {
  constexpr bool kMotions[] = {false, true};
  bool right = true;
  for (const bool rotated : kMotions) {
    for (uint32_t i = 0; i < kProximities; ++i) {
      for (uint32_t pair = 0; pair < kLinkPairs; ++pair) {
        for (uint32_t number = 0; number < kPosesOfPair; ++number) {
          const PoseKey key = {rotated, static_cast<Proximity>(i), pair, number};
          right = call(kPairs[pair], key) && right;
        }
      }
    }
  }
  return right;
}

}  // namespace figures
