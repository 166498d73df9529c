// The instructions to open a robot's image on the target, per joint, pair, vertex and byte, against
// the figures of robot/image.hpp.
#include <catch2/catch.hpp>

#include <cstdio>
#include <vector>

#include "bake/image_bytes.hpp"
#include "flashbvh/detail/robot/image_parts.hpp"
#include "insn.hpp"
#include "support/torus.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// The header's figures for a Cortex-M4, plus a fifth for other cores.
constexpr double kMostPerJoint = 1000;
constexpr double kMostPerLink = 500;
constexpr double kMostPerJointBetween = 36;
constexpr double kMostPerVertex = 132;
constexpr double kMostPerByte = 6;

/// A chain whose last joints carry `links`.
struct Chain {
  Chain(std::uint32_t joint_count, std::uint32_t link_count, std::uint32_t pair_count) {
    for (std::uint32_t i = 0; i < joint_count; ++i) {
      const auto number = static_cast<std::uint8_t>(i);
      const auto parent = i == 0 ? kBase : static_cast<std::uint8_t>(i - 1);
      Frame frame = kIdentityFrame;
      frame.translation[0] = 0x15555;
      joints.push_back({frame, -1, 1, 1, 0, 0, parent, number, JointType::revolute, 0});
    }
    for (std::uint32_t i = 0; i < link_count; ++i) {
      const auto on = i == 0 ? kBase : static_cast<std::uint8_t>(joint_count - 1);
      links.push_back({{1, 2, 3}, 0x333333, static_cast<std::uint16_t>(reaches.size()), on, 0, 0});
      reaches.resize(reaches.size() + (i == 0 ? 0 : joint_count), 7);
    }
    for (std::uint32_t i = 0; i < pair_count; ++i) {
      pairs.push_back({0, 0, 7 * joint_count, 0, static_cast<std::uint8_t>(i + 1), 0,
                       static_cast<std::uint8_t>(joint_count)});
    }
    robot.slack = 228;
    robot.joints = joints.data();
    robot.links = links.data();
    robot.pairs = pairs.data();
    robot.reaches = reaches.data();
    robot.joint_count = robot.variable_count = static_cast<std::uint8_t>(joint_count);
    robot.link_count = static_cast<std::uint8_t>(link_count);
    robot.pair_count = static_cast<std::uint16_t>(pair_count);
    robot.reach_count = static_cast<std::uint16_t>(reaches.size());
  }

  double check() const {
    bool good = false;
    std::uint32_t between = 0;
    const std::uint32_t cost = port::instructions_of([&] { good = check_robot(robot, between); });
    REQUIRE(good);
    return cost;
  }

  std::vector<RobotJoint> joints;
  std::vector<RobotLink> links;
  std::vector<RobotPair> pairs;
  std::vector<std::uint32_t> reaches;
  Robot robot{};
};

void check_cost(const char* of, double cost, double most) {
  std::printf("budget: opening a robot, %.1f instructions a %s, at most %.0f\n", cost, of, most);
  std::fflush(stdout);
  CHECK(cost <= most);
}

}  // namespace

TEST_CASE("opening a robot is linear in its joints, links, pairs, vertices and bytes") {
  const Chain none(0, 1, 0);
  const Chain joints(32, 1, 0);
  const Chain links(32, 33, 0);
  const Chain pairs(32, 33, 32);
  check_cost("joint", (joints.check() - none.check()) / 32, kMostPerJoint);
  check_cost("link on a branch of 32 joints", (links.check() - joints.check()) / 32,
             kMostPerLink + 32 * 12);
  const double longer = pairs.check() - links.check();
  const double shorter = Chain(16, 33, 32).check() - Chain(16, 33, 0).check();
  check_cost("joint between two links", (longer - shorter) / (16 * 32), kMostPerJointBetween);

  const bake::LatticeMesh torus = test::torus(20, 10, 6000, 2000);
  const auto baked =
      bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_default(torus, 1), torus);
  const Mesh mesh = baked.view();
  Chain one(0, 1, 0);
  one.links[0].radius = 20000u << kFrameBits;
  one.robot.meshes = &mesh;
  bool good = false;
  const double spheres = port::instructions_of([&] { good = check_spheres(one.robot); });
  REQUIRE(good);
  check_cost("vertex", spheres / mesh.vertex_count, kMostPerVertex);
  std::uint32_t hash = 0;
  const double hashed = port::instructions_of([&] { hash = robot_hash(one.robot); });
  REQUIRE(hash != 0);
  check_cost("byte of the hash",
             hashed / (mesh.node_count * sizeof *mesh.nodes +
                       mesh.triangle_count * sizeof *mesh.triangles +
                       mesh.vertex_count * sizeof *mesh.vertices),
             kMostPerByte);
}
