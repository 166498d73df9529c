// An arm that can't hit itself, its pedestal or the fence, and that comes out where it is too near:
// a control task at 1 kHz sends the drives as far towards a set point as the guard lets it, and
// checks where the encoders say that the arm is.
//
// The same joint values give the same answers on every core and on the host, bit for bit. The stop
// distance, 5 mm, covers what the guard can't know: the braking distance, the encoders' errors and
// the bending of the arm.
//
// Prints the end of each motion, and the instructions of a period, from floats to the verdict. Run
// it by hand with FLASHBVH_ICOUNT to see the instruction counts (ports/README.md).
#include <flashbvh/clearance.hpp>
#include <flashbvh/robot/guard.hpp>
#include <flashbvh/robot/image.hpp>
#include <flashbvh/robot/robot_float.hpp>
#include <flashbvh/units.hpp>

#include "arm.hpp"
#include "text.hpp"
#include "timer.hpp"

using namespace flashbvh;

namespace {

Mesh meshes[ARM(LINK_COUNT)];
const Robot robot = view_robot_unchecked(ARM(robot_image), meshes);
GuardStateOf<ARM(JOINT_COUNT), ARM(PAIR_COUNT), ARM(PAIR_JOINT_COUNT)> state;

/// In so many periods the arm has to reach a set point, or is held.
constexpr int kPatience = 100;

/// A motion and its progress.
struct Run {
  const Motion& motion;
  Guard guard;
  LimitAnswer limited;
  GuardAnswer last;
  int periods;  ///< in which the arm reached its set point
  int late;     ///< since then
  int warned;   ///< with a warning
  int left;     ///< leaving a stop distance
  int waited;   ///< in which there was too little work
  uint32_t work;
  uint32_t digest;                            ///< of all answers
  JointCoordinate held[ARM(VARIABLE_COUNT)];  ///< the drives' position
};

/// True if the drives may go on. An error is no permission; `leaving` is one for what limit()
/// grants.
bool may_go(const GuardAnswer& answer) {
  return answer.status == Status::done && answer.verdict <= Verdict::leaving;
}

/// FNV-1a over words.
void digest(Run& run) {
  const GuardAnswer& last = run.last;
  const LimitAnswer& limited = run.limited;
  const uint32_t words[] = {
      static_cast<uint32_t>(last.verdict),    last.pair,     last.distance, last.work,
      static_cast<uint32_t>(limited.verdict), limited.share, limited.work};
  for (const uint32_t word : words) {
    run.digest = (run.digest ^ word) * 16777619u;
  }
}

/// The timer's interrupt handler; true if the motion goes on.
bool control(Run& run) {
  if (run.last.verdict == Verdict::not_yet_known) {  // the drives stand still
    run.last = run.guard.go_on(kWork);
    ++run.waited;
    return run.last.status == Status::done;
  }
  float joints[kMostVariables];
  JointCoordinate wanted[ARM(VARIABLE_COUNT)];
  set_point(run.motion, run.periods, joints);
  set_values(robot, joints, wanted);
  run.limited = run.guard.limit(wanted, run.held, kWork);  // run.held: to the drives
  run.last = run.guard.update(run.held, kWork);            // here the encoders say the same
  digest(run);
  const uint32_t work = run.limited.work + run.last.work;
  run.work = work > run.work ? work : run.work;
  if (!may_go(run.last)) {
    return run.last.verdict == Verdict::not_yet_known;
  }
  run.warned += run.last.verdict == Verdict::warn ? 1 : 0;
  run.left += run.last.verdict == Verdict::leaving ? 1 : 0;
  run.waited += run.limited.verdict == LimitVerdict::not_yet_known ? 1 : 0;
  const bool is_there = run.limited.verdict == LimitVerdict::granted;
  run.periods += is_there ? 1 : 0;
  run.late = is_there ? 0 : run.late + 1;
  return run.periods <= run.motion.milliseconds && run.late < kPatience &&
         run.limited.verdict != LimitVerdict::held;
}

/// The distance of a pair of links at these joint values, in 1/256 cell, rounded down; 0 on error.
uint32_t distance_at(const JointCoordinate* values, const RobotPair& pair) {
  JointCoordinate coordinates[ARM(JOINT_COUNT)];
  Frame frames[ARM(JOINT_COUNT)];
  if (set_coordinates(robot, values, coordinates) != Status::done) {
    return 0;
  }
  set_frames(robot, coordinates, frames);
  const auto frame_of = [&](uint8_t link) {
    const uint8_t joint = robot.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames[joint];
  };
  const Pose pose = relative_pose(frame_of(pair.a), frame_of(pair.b));
  const Clearance<uint16_t> known = distance(robot.meshes[pair.a], robot.meshes[pair.b], pose);
  return known.status == Status::done ? known.lower : 0;
}

/// Prints a distance in 1/256 cell as millimetres with three decimals.
void print_mm(uint32_t distance) {
  const auto micrometres = static_cast<uint32_t>(millionths_of(distance, robot.cell_bits));
  const uint32_t part = micrometres % 1000;
  port::print(micrometres / 1000, part < 10 ? ".00" : part < 100 ? ".0" : ".", part, " mm");
}

/// The name of the joint that a variable drives.
const char* name_of(uint8_t variable) {
  uint32_t joint = 0;
  while (robot.joints[joint].variable != variable || robot.joints[joint].shift != 0) {
    ++joint;  // a mimic joint, or another variable's
  }
  return joint_name(ARM(robot_image), joint);
}

/// Prints the links that hold the arm, and their distance; true if the links are still apart.
bool print_stop(Run& run) {
  const RobotPair& pair = robot.pairs[run.limited.pair];
  const uint32_t left = distance_at(run.held, pair);
  port::print(", held by ", link_name(ARM(robot_image), pair.a), " and ",
              link_name(ARM(robot_image), pair.b), " ");
  print_mm(left);
  int32_t changes[ARM(VARIABLE_COUNT)];
  const PairDetail detail = run.guard.explain(run.limited.pair, changes);
  if (detail.variable != kNoVariable) {
    port::print(" apart, out: ", name_of(detail.variable),
                changes[detail.variable] > 0 ? " up" : " down");
  }
  return left > pair.stop;
}

/// Runs a motion and prints its result; true if the motion ended as expected.
bool run_motion(const Motion& motion) {
  Run run = {motion, Guard(robot, state), {}, {}, 0, 0, 0, 0, 0, 0, 2166136261u, {}};
  float joints[kMostVariables];
  set_point(motion, 0, joints);
  set_values(robot, joints, run.held);
  run.last = run.guard.prime(run.held);  // at rest there is time to check all pairs
  const port::TaskTime time =
      port::each_period(kInstructionsAPeriod, [&run] { return control(run); });
  port::print(motion.name, ": ", run.periods, " periods, warned in ", run.warned, ", leaving in ",
              run.left, ", waited in ", run.waited);
  const bool is_held = run.late != 0;
  bool is_right = run.limited.status == Status::done && may_go(run.last);
  if (is_right && is_held) {
    is_right = print_stop(run);
  }
  const uint32_t in_time = time.periods - time.late;
  port::print(", answers' digest ", run.digest, "\n  a period: ", run.work, " work at most, ",
              time.most, " instructions at most, ",
              in_time == 0 ? 0 : static_cast<uint32_t>(time.instructions) / in_time,
              " in the mean, of ", kInstructionsAPeriod, ", late: ", time.late, "\n");
  return is_right && motion.stops == is_held;
}

}  // namespace

int main() {
  bool is_right = true;
  for (const Motion& motion : kMotions) {
    is_right = run_motion(motion) && is_right;
  }
  port::print("RAM: ", unsigned{sizeof state}, " bytes, for views of the robot ",
              unsigned{sizeof meshes + sizeof robot},
              " bytes, flash for the robot: ", unsigned{ARM(IMAGE_BYTES)}, " bytes\n");
  return is_right ? 0 : 1;
}
