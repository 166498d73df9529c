// Images of small arms with all kinds of joints; tests/fuzz/corpus/robot keeps them.
#pragma once

#include <string>
#include <vector>

#include "robot/baked/robot_image.hpp"
#include "support/arms/fixed_arm.hpp"

namespace flashbvh::test {

inline std::vector<std::uint32_t> image_of(const FixedArm& arm,
                                           const std::vector<tool::UnguardedPair>& unguarded = {}) {
  std::vector<std::vector<std::uint32_t>> meshes;
  for (std::size_t i = 0; i < arm.model.links.size(); ++i) {
    meshes.push_back(arm.arm.image(i));
  }
  return tool::robot_image(arm.model, arm.robot(), unguarded, meshes, "arm");
}

struct NamedImage {
  std::string name;
  std::vector<std::uint32_t> words;
};

/// An arm with joints of every type, mimics of a limited joint and of one without limits, a branch,
/// and links of a few triangles.
FixedArm every_joint_arm();
/// All images; the first is of every_joint_arm().
const std::vector<NamedImage>& arm_images();

}  // namespace flashbvh::test
