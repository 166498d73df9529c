// Whole queries, whose stack is measured by call graph and painted.
#pragma once

#include "flashbvh/clearance.hpp"

namespace painted {

struct Scene {
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
  const flashbvh::Pose* pose;
  uint32_t work;
  flashbvh::PairQuery::Pair found[2];
  flashbvh::RunResult step;
  flashbvh::Clearance<uint16_t> clearance;
};

}  // namespace painted

extern "C" {
/// `scene`: a painted::Scene.
void painted_query(void* scene);
void painted_distance(void* scene);
}
