// Coordinates from floats against long doubles.
#include "flashbvh/robot/robot_float.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "support/arms/fixed_arm.hpp"
#include "support/test.hpp"

namespace {

float any_float(Random& random) {
  const auto bits = static_cast<std::uint32_t>(random.next());
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// A float of about this size.
float any_near(Random& random, double size) {
  return static_cast<float>(real_between(random, -size, size));
}

const long double kUnits = kFullTurn / (2 * std::acos(-1.0L));

/// Tests any float: 8 turns exceed 32 bits only by a rounding, so no value is ambiguous.
void check_angle(float radians) {
  CAPTURE(radians);
  const JointCoordinate coordinate = angle_coordinate(radians);
  const long double units = static_cast<long double>(radians) * kUnits;
  if (!(std::fabs(units) < 0x1p31L - 0.5L)) {
    CHECK(coordinate == kNoCoordinate);
  } else {
    // The factor has 64 bits: at an eighth of a turn its rounding is below 2^-30 unit.
    REQUIRE(coordinate != kNoCoordinate);
    CHECK(std::fabs(coordinate - units) <= 0.5L + 0x1p-20L);
  }
}

/// A robot of a joint that slides; `joint` must outlive it.
Robot sliding_robot(RobotJoint& joint, double cell) {
  joint = {};
  joint.type = JointType::prismatic;
  Robot robot{};
  robot.joints = &joint;
  robot.joint_count = robot.variable_count = 1;
  std::memcpy(&robot.cell_bits, &cell, sizeof cell);
  return robot;
}

/// Tests a joint's value and a frame's translation by the cell itself, as the slack assumes.
void check_slide(float length, double cell) {
  CAPTURE(length, cell);
  RobotJoint joint;
  const Robot robot = sliding_robot(joint, cell);
  JointCoordinate coordinate = 0;
  set_values(robot, &length, &coordinate);
  Frame frame{};
  const Status status = set_frame(robot, UnitQuaternion{1, 0, 0, 0}, {0, length, 0}, frame);
  CHECK(frame.translation[1] == coordinate);
  CHECK((status == Status::done) == (coordinate != kNoCoordinate));
  const long double units =
      static_cast<long double>(length) / static_cast<long double>(cell) * kFrameCell;
  if (!(std::fabs(units) <= kMaxJointCoordinate + 0.5L)) {
    CHECK(coordinate == kNoCoordinate);
  } else if (std::fabs(units) < kMaxJointCoordinate - 1) {
    REQUIRE(coordinate != kNoCoordinate);
    CHECK(std::fabs(coordinate - units) <= 0.5L + 1.0L / 256);
  }
}

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kSubnormal = std::numeric_limits<float>::denorm_min();

}  // namespace

TEST_CASE("angles are rounded to the nearest") {
  Random random = test_random();
  for (int i = 0; i < 20'000; ++i) {
    check_angle(any_float(random));
    check_angle(any_near(random, 60));
    check_angle(any_near(random, 1e-6));
    check_angle(any_near(random, std::ldexp(1, -static_cast<int>(random.below(40)))));
  }
  for (const float edge : {50.2654F, 50.265488F, 50.26548F, 50.3F, 63.9F, 64.0F, 1e30F, kInfinite,
                           kNotANumber, kSubnormal, 1e-38F, 0.0F, 1.2e-8F, 1.1e-8F}) {
    check_angle(edge);
    check_angle(-edge);
  }
  CHECK(angle_coordinate(-0.0F) == 0);
}

TEST_CASE("lengths are rounded to the nearest, exactly for each cell of a robot") {
  Random random = test_random();
  for (int i = 0; i < 20'000; ++i) {
    float length = any_near(random, 8);
    check_slide(length, real_between(random, 2e-5, 4e-5));
    length = any_near(random, 1);
    check_slide(length, real_between(random, 1e-6, 1));
    check_slide(any_near(random, 600'000), 1);
    length = any_float(random);
    const double cell = real_between(random, 1, 2);
    check_slide(length, std::ldexp(cell, -static_cast<int>(random.below(40))));
  }
  for (const float edge : {kInfinite, kNotANumber, kSubnormal, 0.0F, 524'288.0F, 524'289.0F, 3e38F,
                           0x1p-12F, 0x3p-12F, 1e-30F}) {
    for (const double cell : {1.0, 1e-9, 0x1p-40, 1e9}) {
      check_slide(edge, cell);
      check_slide(-edge, cell);
    }
  }
  RobotJoint joint;
  const Robot robot = sliding_robot(joint, 1);
  for (const int halves : {1, -1, 3, -3}) {
    const float length = static_cast<float>(halves) * 0x1p-12F;
    JointCoordinate coordinate = 0;
    set_values(robot, &length, &coordinate);
    CHECK(coordinate == (halves + 1) / 2);  // halves go up
  }
}

TEST_CASE("values of a robot: each by its joint's type, mimics take none") {
  Model model;
  const std::size_t turns = add_joint(model, tool::kNoJoint, {}, JointType::revolute, -1, 1);
  add_mimic(model, turns, {}, JointType::prismatic, 0, 0.01, 0);
  const std::size_t slides = add_joint(model, turns, {}, JointType::prismatic, 0, 0.5);
  add_joint(model, slides, {}, JointType::continuous, -kPi, kPi);
  add_link(model, slides, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 1.0 / 1024);
  const float floats[] = {0.5F, 0.25F, kNotANumber};
  JointCoordinate values[3];
  set_values(arm.robot(), floats, values);
  CHECK(values[0] == angle_coordinate(0.5F));
  CHECK(values[1] == 256 * kFrameCell);
  CHECK(values[2] == kNoCoordinate);
  JointCoordinate coordinates[4];
  CHECK(set_coordinates(arm.robot(), values, coordinates) == Status::not_a_coordinate);
}

TEST_CASE("a frame from floats is that of its matrix or quaternion") {
  Model model;
  const std::size_t joint = add_joint(model, tool::kNoJoint, {}, JointType::revolute, -1, 1);
  add_link(model, joint, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 0.002);
  const float half = 0.70710678f;
  const float matrix[3][3] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  const float metres[3] = {1, -0.5f, 0.001f};
  Frame a;
  Frame b;
  REQUIRE(set_frame(arm.robot(), matrix, metres, a) == Status::done);
  REQUIRE(set_frame(arm.robot(), UnitQuaternion{half, 0, 0, half}, metres, b) == Status::done);
  CHECK(a.translation[0] == 500 * kFrameCell);
  CHECK(a.translation[2] == kFrameCell / 2);
  CHECK(a.rotation[1][0] == kRotationOne);
  for (int i = 0; i < 3; ++i) {
    CHECK(a.translation[i] == b.translation[i]);
    for (int j = 0; j < 3; ++j) {
      CHECK(std::abs(a.rotation[i][j] - b.rotation[i][j]) < 100);
    }
  }
  const float far[3] = {1e9f, 0, 0};
  CHECK(set_frame(arm.robot(), matrix, far, a) == Status::translation_out_of_range);
}
