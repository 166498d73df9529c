// Pairs of meshes of well-shaped triangles, and their poses: made by scenes.py.
#pragma once

#include <stdint.h>

#include "flashbvh/mesh.hpp"

namespace compare {

struct ScenePair {
  const char* a_name;
  const char* b_name;
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
};
constexpr uint32_t kScenePosesOfClass = 8;
extern const ScenePair kScenes[];
extern const uint32_t kSceneCount;
/// By pair, motion, class and number: a quaternion of any length, and a translation in cells.
extern const int32_t kScenePoses[][7];

}  // namespace compare
