// An arm that can't hit itself, its pedestal or the fence: a control task at 1 kHz hands a set
// point to the drives only if the guard lets it.
//
// The same joint values give the same answers on every core and on the host, bit for bit. A loop
// stands for the timer's interrupt. The stop distance, 5 mm, is for what the guard can't know: how
// far the arm still goes until it stands, and what encoders and a bent arm are wrong by.
//
// Prints for each motion how it ended, and the instructions of a period, from floats to the
// verdict. They are counted, so run it by hand with FLASHBVH_ICOUNT (ports/README.md).
#include <flashbvh/clearance.hpp>
#include <flashbvh/length.hpp>
#include <flashbvh/robot/guard.hpp>
#include <flashbvh/robot/robot_float.hpp>

#include "insn.hpp"
#include "motions.hpp"
#include "text.hpp"

using namespace flashbvh;
using cell_arm::kVariableCount;

namespace {

/// Of a period, in units of query.hpp.
constexpr uint32_t kWork = 150;

cell_arm::GuardState state;

/// How a motion ended, or how far it got.
struct Run {
  GuardAnswer last;
  int periods = 0;  ///< that the drives went
  int warned = 0;   ///< of these
  int waited = 0;   ///< periods in which the drives stood, since an answer took longer
  uint32_t work = 0;
  uint32_t most_instructions = 0;
  uint64_t instructions = 0;
  JointCoordinate held[kVariableCount];  ///< where the drives stand
};

/// The set point's answer, or more work on it.
GuardAnswer ask(Guard& guard, const float* joints, bool goes_on, JointCoordinate* values) {
  set_values(cell_arm::robot, joints, values);
  return goes_on ? guard.go_on(kWork) : guard.update(values, kWork);
}

/// Whether the drives may go there. An error is no permission.
bool may_go(const GuardAnswer& answer) {
  return answer.status == Status::done && answer.verdict <= Verdict::warn;
}

/// One interrupt of the timer. Whether the motion goes on.
bool tick(Guard& guard, const Motion& motion, Run& run) {
  float joints[kVariableCount];
  JointCoordinate values[kVariableCount];
  set_point(motion, run.periods, joints);
  const bool goes_on = run.last.verdict == Verdict::not_yet_known;
  const uint32_t instructions =
      port::instructions_of([&] { run.last = ask(guard, joints, goes_on, values); });
  run.instructions += instructions;
  run.most_instructions =
      instructions > run.most_instructions ? instructions : run.most_instructions;
  run.work = run.last.work > run.work ? run.last.work : run.work;
  if (!may_go(run.last)) {
    const bool waits = run.last.status == Status::done && run.last.verdict != Verdict::stop;
    run.waited += waits ? 1 : 0;
    return waits;
  }
  for (uint32_t i = 0; i < kVariableCount; ++i) {
    run.held[i] = values[i];  // to the drives
  }
  run.warned += run.last.verdict == Verdict::warn ? 1 : 0;
  return ++run.periods <= motion.milliseconds;
}

Run run_motion(const Motion& motion) {
  Guard guard(cell_arm::robot, state);
  Run run;
  float joints[kVariableCount];
  set_point(motion, 0, joints);
  set_values(cell_arm::robot, joints, run.held);
  run.last = guard.prime(run.held);  // at rest there is time for all of it
  while (run.last.verdict != Verdict::stop && tick(guard, motion, run)) {
  }
  return run;
}

const char* name_of(uint8_t link) {
  switch (link) {
    case cell_arm::links::base:
      return "base";
    case cell_arm::links::fence:
      return "fence";
    case cell_arm::links::turret:
      return "turret";
    case cell_arm::links::upper_arm:
      return "upper arm";
    case cell_arm::links::forearm:
      return "forearm";
    default:
      return "gripper";
  }
}

/// The links' distance where the drives stand, in 1/256 cell.
uint32_t distance_at(const JointCoordinate* values, const RobotPair& pair) {
  JointCoordinate coordinates[cell_arm::kJointCount];
  Frame frames[cell_arm::kJointCount];
  if (set_coordinates(cell_arm::robot, values, coordinates) != Status::done) {
    return 0;
  }
  set_frames(cell_arm::robot, coordinates, frames);
  const auto frame_of = [&](uint8_t link) {
    const uint8_t joint = cell_arm::robot.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames[joint];
  };
  const Pose pose = relative_pose(frame_of(pair.a), frame_of(pair.b));
  const Clearance<uint16_t> known =
      distance(cell_arm::robot.meshes[pair.a], cell_arm::robot.meshes[pair.b], pose);
  return known.status == Status::done ? known.lower : 0;
}

/// With three decimals.
void print_mm(uint32_t distance) {
  const auto micrometres =
      static_cast<uint32_t>(millionths_of(distance, cell_arm::robot.cell_bits));
  const uint32_t part = micrometres % 1000;
  port::print(micrometres / 1000, part < 10 ? ".00" : part < 100 ? ".0" : ".", part, " mm");
}

/// Whether it ended as it should: where it was stopped, the links are still apart.
bool tell(const Motion& motion) {
  const Run run = run_motion(motion);
  port::print(motion.name, ": ", run.periods, " periods, warned in ", run.warned, ", waited in ",
              run.waited);
  bool is_right = run.last.status == Status::done;
  if (is_right && run.last.verdict == Verdict::stop) {
    const RobotPair& pair = cell_arm::robot.pairs[run.last.pair];
    const uint32_t left = distance_at(run.held, pair);
    port::print(", stopped with ", name_of(pair.a), " and ", name_of(pair.b), " ");
    print_mm(left);
    is_right = left > pair.stop;
  }
  const auto asked = static_cast<uint32_t>(run.periods + run.waited + (may_go(run.last) ? 0 : 1));
  port::print("\n  a period: ", run.work, " work at most, ", run.most_instructions,
              " instructions at most, ", static_cast<uint32_t>(run.instructions) / asked,
              " in the mean\n");
  return is_right && (motion.end == Verdict::stop) == (run.last.verdict == Verdict::stop);
}

}  // namespace

int main() {
  bool is_right = true;
  for (const Motion& motion : kMotions) {
    is_right = tell(motion) && is_right;
  }
  port::print("RAM: ", unsigned{sizeof(state)},
              " bytes, flash for the robot: ", unsigned{cell_arm::kFlashBytes}, " bytes\n");
  return is_right ? 0 : 1;
}
