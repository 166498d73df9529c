// Measures periods of a small arm's guard with hard meshes, to compare with the proven bounds:
//   run period WORK JOINTS PAIRS BETWEEN TABLED DEPTH LEAF_SIZE INSTRUCTIONS
// WORK: the budget. BETWEEN: joints between the links of all pairs; TABLED: pairs with one or two
// such joints. DEPTH and LEAF_SIZE: the largest of two meshes, and of any.
#include "flashbvh/detail/robot/distance_table.hpp"
#include "guard_slice.hpp"
#include "hard_mesh.hpp"
#include "insn.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;
using flashbvh::test::Random;

namespace bound {
namespace {

constexpr uint32_t kJoints = 4;
constexpr uint32_t kLinks = 3;
constexpr uint32_t kPairs = 3;
constexpr uint32_t kBetween = 8;
constexpr uint32_t kTabled = 2;

constexpr uint32_t kScenes = 36;
constexpr uint32_t kPeriods = 10;
constexpr uint32_t kGranted[] = {1, 40, 400, 2000};
constexpr uint64_t kSeed = 0x7065726F64u;
constexpr int32_t kLimit = kFullTurn / 4;

/// Two axes of 32 joint boxes for each pair with a table: most bytes are 0.
struct Tables {
  uint8_t at[kTabled * 1024] = {};
  constexpr Tables() {
    for (uint32_t i = 0; i < sizeof at; i += 5) {
      at[i] = static_cast<uint8_t>(i % 251);
    }
  }
};
constexpr Tables kTables;

// Static, since the smallest core's stack is too small.
Side sides[kLinks];
Mesh meshes[kLinks];
RobotJoint joints[kJoints];
RobotLink links[kLinks];
RobotPair pairs[kPairs];
uint32_t reaches[2 + kJoints];
GuardStateOf<kJoints, kPairs, kBetween> state;

/// Joint types: revolute, prismatic, continuous (a mimic of the second one), revolute. `far`: the
/// ratio of distances to the meshes' size.
void make_joint(Random& random, uint32_t i, int32_t reach, int32_t far) {
  constexpr JointType types[] = {JointType::revolute, JointType::prismatic, JointType::continuous,
                                 JointType::revolute};
  Frame frame = kIdentityFrame;
  const test::Rotation turned = test::rotation_of(
      {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9), random.between(1, 9)});
  for (uint32_t row = 0; row < 3; ++row) {
    for (uint32_t column = 0; column < 3; ++column) {
      frame.rotation[row][column] = turned.entry[row][column];
    }
    frame.translation[row] = random.between(-reach, reach) * (kFrameCell / 4) * far;
  }
  const bool is_mimic = i == 2;
  const int32_t most = types[i] == JointType::prismatic ? reach * kFrameCell / 4 : kLimit;
  joints[i] = {frame,
               -most,
               most,
               is_mimic ? 3 : 0,
               0,
               static_cast<uint8_t>(is_mimic ? 1 : 0),
               i == 0 ? kBase : static_cast<uint8_t>(i - 1),
               static_cast<uint8_t>(is_mimic ? 1 : i),
               types[i],
               0};
}

bool make_robot(Random& random, int32_t reach, Robot& robot) {
  // Some arms lie beyond any distance, with spheres that decide nothing.
  const bool is_far = random.below(8) == 0;
  const int32_t far = is_far ? 400000 / reach : 1;
  for (uint32_t i = 0; i < kJoints; ++i) {
    make_joint(random, i, reach, far);
  }
  for (uint32_t i = 0; i < kLinks; ++i) {
    if (!make_side(random, reach, sides[i])) {
      return false;
    }
    meshes[i] = sides[i].tree.view();
    // The links: on the base, the second and the last joint.
    links[i] = {{0, 0, 0},
                is_far ? uint32_t{1} << 30 : static_cast<uint32_t>(reach) * 1024u,
                static_cast<uint16_t>(i == 2 ? 2 : 0),
                i == 0 ? kBase : static_cast<uint8_t>(2 * i - 1),
                0,
                0};
  }
  for (uint32_t& of_joint : reaches) {
    of_joint = static_cast<uint32_t>(reach) * 400u;
  }
  const uint32_t stop = random.below(3) * 64;
  const uint32_t warn = stop + random.below(static_cast<uint32_t>(reach) * 64 + 1);
  const uint32_t each = static_cast<uint32_t>(reach) * 400u;
  pairs[0] = {stop, warn, 2 * each, 0, 1, 0, 2};
  pairs[1] = {stop, warn, 2 * each, 2, 1, 2, 0};
  pairs[2] = {stop, warn, 4 * each, 0, 2, 0, 4};
  robot.joints = joints;
  robot.links = links;
  robot.meshes = meshes;
  robot.pairs = pairs;
  robot.reaches = reaches;
  robot.distance_tables = kTables.at;
  robot.distance_table_bytes = random.below(2) == 0 ? 0 : sizeof kTables.at;
  robot.joint_count = robot.variable_count = kJoints;
  robot.link_count = kLinks;
  robot.pair_count = kPairs;
  robot.reach_count = sizeof reaches / sizeof *reaches;
  robot.slack = 2;
  robot.hash = 1;  // as of an opened image
  robot.cell_bits = meshes[0].cell_bits;
  return true;
}

uint32_t greatest(uint32_t Side::*of) {
  uint32_t most = 0;
  for (const Side& side : sides) {
    most = side.*of > most ? side.*of : most;
  }
  return most;
}

/// Moves usually by a little, sometimes anywhere or not at all.
void move(Random& random, JointCoordinate (&values)[kJoints]) {
  const uint32_t how = random.below(6);
  for (uint32_t i = 0; i < kJoints; ++i) {
    const int32_t most = joints[i].upper;
    const int32_t by = how == 0 ? 0 : how == 1 ? most : most >> random.between(4, 14);
    const int32_t to = (how == 1 ? 0 : values[i]) + random.between(-by, by);
    values[i] = to < -most ? -most : to > most ? most : to;
  }
}

bool measure_guard(Random& random, const Robot& robot, uint32_t granted) {
  Guard guard(robot, state);
  JointCoordinate values[kJoints] = {};
  Period period = {&guard, values, granted, {}};
  for (uint32_t i = 0; i < kPeriods; ++i) {
    const uint32_t instructions = port::instructions_of_call(bound_period, &period);
    bound_done();
    if (period.answer.status == Status::guard_state_invalid ||
        period.answer.status == Status::not_open) {
      return false;
    }
    port::print("run period ", granted, " ", kJoints, " ", kPairs, " ", kBetween, " ", kTabled,
                " ");
    port::print(2 * greatest(&Side::depth), " ", greatest(&Side::leaf_size), " ", instructions,
                "\n");
    move(random, values);
  }
  return true;
}

bool measure_all() {
  Random random(kSeed);
  for (uint32_t i = 0; i < kScenes; ++i) {
    constexpr int32_t reaches_of_meshes[] = {3, 30, 1000, 8000};
    Robot robot = {};
    if (!make_robot(random, reaches_of_meshes[i % 4], robot)) {
      return false;
    }
    for (const uint32_t granted : kGranted) {
      if (!measure_guard(random, robot, granted)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace
}  // namespace bound

int main() {
  return bound::measure_all() ? 0 : 1;
}
