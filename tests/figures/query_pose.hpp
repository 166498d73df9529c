// The queries behind the figures: two meshes, a pose, and its known counts.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "support/rotations.hpp"

namespace figures {

/// The proximity of two meshes, in the terms of the paper's section 9.1.
enum class Proximity : uint8_t {
  separated,     ///< the boxes of the roots are disjoint: one visit decides
  small,         ///< they overlap, at most kFewLeafPairs pairs of leaves do, no triangles intersect
  close,         ///< more pairs of leaves overlap, no triangles intersect
  intersecting,  ///< triangles intersect
};

constexpr const char* kProximityNames[] = {"separated", "small", "close", "intersecting"};
constexpr uint32_t kProximities = 4;
constexpr uint32_t kFewLeafPairs = 10;

/// Poses of one class under one kind of motion, for one pair of meshes.
constexpr uint32_t kPosesOfPair = 16;

/// A pose, in integers so that it is equal everywhere, and the counts of its query by `ranked`,
/// which every core must repeat.
struct QueryPose {
  int16_t quaternion[4];  ///< w, x, y, z, of any length; 1 0 0 0 for a translation
  int32_t cells[3];
  uint32_t visits;
  uint32_t leaf_pairs;
  uint32_t triangle_pairs;
  uint32_t work;
};

/// Two meshes and their poses: translations, and rotations.
struct MeshPair {
  const char* a_name;
  const char* b_name;
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
  QueryPose translated[kProximities][kPosesOfPair];
  QueryPose rotated[kProximities][kPosesOfPair];
};

/// Written by write_poses.
extern const MeshPair kMeshPairs[];
extern const uint32_t kMeshPairCount;

/// The pose, or the pose `along_x` cells further.
inline flashbvh::Pose pose_of(const QueryPose& query_pose, int32_t along_x = 0) {
  const int16_t(&q)[4] = query_pose.quaternion;
  const int32_t cells[3] = {query_pose.cells[0] + along_x, query_pose.cells[1],
                            query_pose.cells[2]};
  return flashbvh::Pose::rigid(flashbvh::test::rotation_of({q[0], q[1], q[2], q[3]}).entry, cells);
}

/// Calls `call(pair, query_pose, motion, proximity)` for each pose of `count` pairs; MOTION is
/// translated or rotated. Returns whether all calls return true.
template <class Call>
bool for_each_query_pose(const Call& call, const MeshPair* pairs = kMeshPairs,
                         uint32_t count = kMeshPairCount) {
  bool right = true;
  constexpr bool kRotated[] = {false, true};
  for (const bool rotated : kRotated) {
    for (uint32_t i = 0; i < kProximities; ++i) {
      for (uint32_t p = 0; p < count; ++p) {
        const MeshPair& pair = pairs[p];
        for (const QueryPose& query_pose : (rotated ? pair.rotated : pair.translated)[i]) {
          right = call(pair, query_pose, rotated ? "rotated" : "translated", kProximityNames[i]) &&
                  right;
        }
      }
    }
  }
  return right;
}

}  // namespace figures
