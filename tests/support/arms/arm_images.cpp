#include "support/arms/arm_images.hpp"

namespace flashbvh::test {
namespace {

/// A pyramid with three sides, of about `size`.
bake::SourceMesh pyramid(double size) {
  bake::SourceMesh mesh;
  mesh.vertices = {
      {0, 0, size}, {size / 4, 0, 0}, {-size / 8, size / 5, 0}, {-size / 8, -size / 5, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

std::vector<NamedImage> made_images() {
  std::vector<NamedImage> images = {
      {"every_joint",
       image_of(every_joint_arm(), {tool::UnguardedPair{0, 1, WhyUnguarded::zone, 0, 0.05},
                                    tool::UnguardedPair{2, 3, WhyUnguarded::believed}})}};
  Model one;
  add_joint(one, tool::kNoJoint, {}, JointType::revolute, -1, 1);
  add_link(one, tool::kNoJoint, pyramid(0.1));
  images.push_back({"one_link", image_of(FixedArm(one, 1e-3))});
  Model two;
  add_joint(two, tool::kNoJoint, shifted({0, 0, 0.01}), JointType::revolute, -3, 3);
  add_joint(two, 0, shifted({0, 0.02, 0.1}), JointType::prismatic, 0, 0.4);
  add_link(two, tool::kNoJoint, pyramid(0.2));
  add_link(two, 1, pyramid(0.2));
  images.push_back({"two_links", image_of(FixedArm(two, 1e-4, {{0, 1, 0.01, 0.03}}, true))});
  return images;
}

}  // namespace

FixedArm every_joint_arm() {
  Model model;
  const std::size_t turn =
      add_joint(model, tool::kNoJoint, shifted({0, 0, 0.3}), JointType::revolute, -2, 2.5);
  const std::size_t slide = add_joint(model, turn, composed(shifted({0, 0.05, 0.25}), turned(0, 1)),
                                      JointType::prismatic, -0.1, 0.2);
  const std::size_t spin =
      add_joint(model, slide, composed(shifted({0.1, 0, 0.2}), turned(1, -kPi / 2)),
                JointType::continuous, -kPi, kPi);
  const std::size_t follower =
      add_mimic(model, turn, shifted({0.1, 0, 0.1}), JointType::revolute, 0, -0.5, 0.25);
  add_mimic(model, spin, shifted({0, 0.1, 0.1}), JointType::continuous, 2, -2, 0.5);
  add_link(model, tool::kNoJoint, pyramid(0.25));
  for (const std::size_t joint : {turn, slide, spin, follower, follower + 1}) {
    add_link(model, joint, pyramid(0.2));
  }
  return FixedArm(model, 1e-3,
                  {{0, 2, 0.01, 0.02}, {0, 3, 0, 0.05}, {2, 4, 0.005, 0.005}, {4, 5, 0.01, 0.1}});
}

const std::vector<NamedImage>& arm_images() {
  static const std::vector<NamedImage> images = made_images();
  return images;
}

}  // namespace flashbvh::test
