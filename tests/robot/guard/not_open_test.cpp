// Robots that nobody opened: no verdict permits anything.
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/motion.hpp"
#include "flashbvh/robot/robot_float.hpp"
#include "robot/baked/robot_image.hpp"
#include "support/arms/any_workcell.hpp"
#include "support/arms/refused.hpp"
#include "support/test.hpp"

namespace {

/// Checks that no guard, motion or workcell takes the robot.
void check_not_open(const Robot& robot, const Values& values, const Mesh& body) {
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(robot, *state);
  check_refused(guard, values.data());
  Guard in_bytes(robot, state.get(), sizeof *state);
  check_refused(in_bytes, values.data());
  MotionStateOf<12, 12> motion_state{};
  MotionQuery motion(robot, motion_state);
  check_refused(motion, values.data());
  MotionQuery motion_in_bytes(robot, &motion_state, sizeof motion_state);
  check_refused(motion_in_bytes, values.data());
  const auto memory = std::make_unique<AnyWorkcell>();
  Workcell workcell(robot, *memory);
  check_refused(workcell, body);
  Workcell in_room(robot, memory.get(), sizeof *memory, {12, 16, 64, 128});
  check_refused(in_room, body);
  Guard of_workcell(workcell.robot(), *state);
  check_refused(of_workcell, values.data());
  JointCoordinate coordinates[kMaxJoints];
  CHECK(set_coordinates(robot, values.data(), coordinates) == Status::not_open);
  Frame frame;
  const Status framed = set_frame(robot, UnitQuaternion{1, 0, 0, 0}, {0, 0, 0}, frame);
  CHECK(framed == (robot.cell_bits == 0 ? Status::not_open : Status::done));
}

}  // namespace

TEST_CASE("no guard, motion or workcell takes a robot that is not open") {
  Random random = test_random();
  const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
  const Values values = arm.any_values(random);
  const Body body(random);
  check_not_open(Robot{}, values, body.mesh());
  Robot without = arm.robot();
  without.joint_count = 0;
  check_not_open(without, values, body.mesh());
  without = arm.robot();
  without.hash = 0;
  check_not_open(without, values, body.mesh());
  without = arm.robot();
  without.cell_bits = 0;
  check_not_open(without, values, body.mesh());
}

TEST_CASE("a guard and a motion refuse once their robot is not open any longer") {
  Random random = test_random(1);
  const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
  const Values values = arm.any_values(random);
  Robot robot = arm.robot();
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(robot, *state);
  MotionStateOf<12, 12> motion_state{};
  MotionQuery motion(robot, motion_state);
  REQUIRE(guard.prime(values.data()).status == Status::done);
  REQUIRE(motion.start(values.data(), values.data()) == Status::done);
  guard.seal();
  robot = {};
  CHECK(guard.verify() == Status::guard_state_invalid);
  CHECK(is_refused(guard.go_on(UINT32_MAX)));
  CHECK(is_refused(guard.update(values.data(), UINT32_MAX)));
  CHECK(is_refused(guard.go_on(UINT32_MAX)));
  CHECK(is_refused(guard.prime(values.data())));
  CHECK(guard.resume() == Status::not_open);
  CHECK(motion.run(UINT32_MAX).status == Status::not_open);
  CHECK(motion.start(values.data(), values.data()) == Status::not_open);
  CHECK(motion.run(UINT32_MAX).status == Status::not_open);
}

TEST_CASE("a workcell takes no body that is not open, and no unusable one") {
  Random random = test_random(2);
  const FixedArm arm = any_guarded_arm(random, 3, kWorkcellCell);
  const auto memory = std::make_unique<AnyWorkcell>();
  Workcell workcell(arm.robot(), *memory);
  std::uint8_t link = 77;
  CHECK(workcell.status() == Status::done);
  CHECK(workcell.add(Mesh{}, {kBase, kIdentityFrame}, link) == Status::not_open);
  const Body body(random);
  Mesh unusable = body.mesh();
  unusable.cell_bits |= std::uint64_t{1} << 63;
  CHECK(workcell.add(unusable, {kBase, kIdentityFrame}, link) == Status::cell_mismatch);
  CHECK(workcell.robot().link_count == arm.robot().link_count);
}

TEST_CASE("a state without values is not resumed") {
  Random random = test_random(4);
  const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
  const Values values = arm.any_values(random);
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(arm.robot(), *state);
  CHECK(guard.resume() == Status::guard_state_invalid);
  REQUIRE(guard.prime(values.data()).status == Status::done);
  CHECK(guard.resume() == Status::done);
  guard.forget();
  CHECK(guard.resume() == Status::guard_state_invalid);
  Values wrong = values;
  wrong[0] = kNoCoordinate;
  CHECK(guard.prime(wrong.data()).status == Status::not_a_coordinate);
  CHECK(guard.resume() == Status::guard_state_invalid);
  CHECK(guard.go_on(UINT32_MAX).verdict == Verdict::refused);
}
