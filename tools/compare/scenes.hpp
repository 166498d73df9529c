// Pairs of meshes of well-shaped triangles, and their poses: made by scenes.py.
#pragma once

#include <stdint.h>

#include "links.hpp"

namespace compare {

constexpr uint32_t kScenePosesOfClass = 8;
extern const figures::LinkPair kScenes[];
extern const uint32_t kSceneCount;
/// By pair, motion, class and number: a quaternion of any length, and a translation in cells.
extern const int32_t kScenePoses[][7];

}  // namespace compare
