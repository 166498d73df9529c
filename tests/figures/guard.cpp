// The guard of the KR5 at 1 kHz: 20 s of motion at half of the joints' top speed and at a tenth,
// and certified motions, of which the guard must stop no period.
#include "flashbvh/robot/guard.hpp"

#include "costs.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/motion.hpp"
#include "kr5_arm.robot.h"
#include "support/random.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20261121;
constexpr uint32_t kPeriods = 20000;
constexpr uint32_t kMotions = 64;
/// The work budget of each period.
constexpr uint32_t kWork = 680;
/// Periods with less work do not count for the cost of its unit.
constexpr uint32_t kMuchWork = 150;
/// Pairs of links in robots that are made to measure them.
constexpr uint32_t kCopies = 8;

constexpr uint32_t kJoints = kr5_arm_JOINT_COUNT;
using MotionState = MotionStateOf<kr5_arm_VARIABLE_COUNT, kJoints>;

// Units of a joint's coordinate per period at top speed: 375, 300, 375, 410, 410 and 660 degrees
// per second.
constexpr int32_t kTop[kJoints] = {279620, 223696, 279620, 305719, 305719, 492132};

Mesh meshes[kr5_arm_LINK_COUNT];
const Robot robot = view_robot_unchecked(kr5_arm_robot_image, meshes);
GuardStateOf<kr5_arm_JOINT_COUNT, kr5_arm_PAIR_COUNT, kr5_arm_PAIR_JOINT_COUNT> guard_memory;
GuardStateOf<kJoints, kCopies, kCopies * kJoints> copies_memory;
MotionState motion_memory;

/// The fixed part of a period that measures a pair: it looks at all pairs twice.
uint32_t least_with_work;

/// Cubic motions of an arm between random poses, during which no links intersect. Computed in
/// integers, so every core and the host run equal motions.
class Motions {
 public:
  /// `percent`: of the top speed of the slowest joint; the other joints take equally long.
  explicit Motions(uint32_t percent) : percent_(percent) {}

  /// The current joint values, at first 0.
  const JointCoordinate* values() const { return values_; }

  /// Moves on by a period.
  void next() {
    if (at_ == periods_) {
      begin();
    }
    ++at_;
    // 3x^2 - 2x^3, x with 15 fraction bits.
    const int64_t x = (int64_t{at_} << 15) / periods_;
    const int64_t share = (x * x >> 15) * (3 * 32768 - 2 * x);
    for (uint32_t i = 0; i < kJoints; ++i) {
      const int64_t way = static_cast<int64_t>(to_[i]) - from_[i];
      values_[i] = static_cast<int32_t>(from_[i] + (way * share >> 30));
    }
  }

 private:
  void begin() {
    do {
      periods_ = 1;
      at_ = 0;
      for (uint32_t i = 0; i < kJoints; ++i) {
        const RobotJoint& joint = robot.joints[i];
        from_[i] = values_[i];
        to_[i] = random_.between(joint.lower, joint.upper);
        // A cubic's top speed is 3/2 of its mean one.
        const int64_t way = static_cast<int64_t>(to_[i]) - from_[i];
        const auto periods =
            static_cast<uint32_t>((way < 0 ? -way : way) * 150 / (int64_t{kTop[i]} * percent_)) + 1;
        periods_ = periods > periods_ ? periods : periods_;
      }
    } while (query_.start(from_, to_) != Status::done ||
             query_.run(UINT32_MAX).outcome != MotionOutcome::free);
  }

  MotionQuery query_{robot, motion_memory};
  uint32_t percent_;
  test::Random random_{kSeed};
  JointCoordinate from_[kJoints] = {};
  JointCoordinate to_[kJoints] = {};
  JointCoordinate values_[kJoints] = {};
  uint32_t periods_ = 0;
  uint32_t at_ = 0;
};

/// Returns whether the guard stops no period.
bool guard_motions(const char* name, uint32_t percent) {
  Motions motions(percent);
  Guard guard(robot, guard_memory);
  bool good = guard.prime(motions.values()).verdict == Verdict::free;
  uint32_t unknown = 0;
  for (uint32_t i = 0; i < kPeriods; ++i) {
    motions.next();
    GuardAnswer answer = {};
    const uint32_t instructions =
        port::instructions_of([&] { answer = guard.update(motions.values(), kWork); });
    add_figure({{"guard", name}}, instructions);
    if (answer.work >= kMuchWork) {
      add_figure({{"guard", "work"}}, (instructions - least_with_work) / answer.work);
    }
    add_to_digest(answer.work);
    add_to_digest(static_cast<uint32_t>(answer.verdict));
    good = good && answer.status == Status::done && answer.verdict != Verdict::stop;
    unknown += answer.verdict == Verdict::not_yet_known ? 1 : 0;
  }
  add_count({{"guard", "unknown", name}}, unknown);
  return good;
}

/// Returns whether limit() lets each command through and update() agrees.
bool limit_motions(uint32_t percent) {
  Motions motions(percent);
  Guard guard(robot, guard_memory);
  bool good = guard.prime(motions.values()).verdict == Verdict::free;
  JointCoordinate granted[kJoints];
  for (uint32_t i = 0; i < kPeriods; ++i) {
    motions.next();
    LimitAnswer limited = {};
    GuardAnswer answer = {};
    measure({{"guard", "limited"}}, [&] {
      limited = guard.limit(motions.values(), granted, kWork);
      answer = guard.update(granted, kWork);
    });
    add_to_digest(limited.work + limited.share);
    add_to_digest(answer.work);
    good = good && limited.status == Status::done && answer.verdict != Verdict::stop;
  }
  return good;
}

/// Certifies motions of up to 1 radian per joint. Returns whether some are free.
bool certify_motions() {
  constexpr int32_t radian = 42722830;
  test::Random random(kSeed);
  MotionQuery query(robot, motion_memory);
  JointCoordinate from[kJoints];
  JointCoordinate to[kJoints];
  uint32_t certified = 0;
  for (uint32_t i = 0; i < kMotions; ++i) {
    for (uint32_t j = 0; j < kJoints; ++j) {
      const RobotJoint& joint = robot.joints[j];
      from[j] = random.between(joint.lower, joint.upper);
      const int32_t by = random.between(-radian, radian);
      to[j] = by > joint.upper - from[j]   ? joint.upper
              : by < joint.lower - from[j] ? joint.lower
                                           : from[j] + by;
    }
    MotionAnswer answer = {};
    const uint32_t instructions = port::instructions_of([&] {
      (void)query.start(from, to);
      answer = query.run(UINT32_MAX);
    });
    if (answer.status == Status::done && answer.outcome == MotionOutcome::free) {
      add_figure({{"guard", "certify"}}, instructions);
      ++certified;
    }
  }
  add_to_digest(certified);
  return certified != 0;
}

bool measure_opening() {
  Robot opened;
  Status status{};
  measure({{"guard", "open"}}, [&] {
    status = open_robot(kr5_arm_robot_image, sizeof kr5_arm_robot_image, meshes, kr5_arm_LINK_COUNT,
                        opened);
  });
  return status == Status::done;
}

/// The instructions of a period without work.
uint32_t standing(Guard& guard) {
  const JointCoordinate zeros[kJoints] = {};
  (void)guard.prime(zeros);
  return port::instructions_of([&] { (void)guard.update(zeros, kWork); });
}

/// The same of a robot with so many joints, and with copies of a pair.
uint32_t standing_with(uint8_t joints, uint16_t pairs, const RobotPair& pair) {
  RobotPair copies[kCopies];
  for (RobotPair& copy : copies) {
    copy = pair;
  }
  Robot made = robot;
  made.joint_count = joints;
  made.pair_count = pairs;
  made.pairs = copies;
  Guard guard(made, copies_memory);
  return standing(guard);
}

/// Prints the parts of a period without work: by a joint, a pair, and a joint between a pair.
void measure_fixed_part() {
  const RobotPair& far = robot.pairs[0];  // the base and a link beyond some joints
  RobotPair near = far;
  near.joints_b = 1;
  const uint32_t none = standing_with(kJoints, 0, near);
  const uint32_t joint = (none - standing_with(1, 0, near)) / (kJoints - 1);
  const uint32_t all_near = standing_with(kJoints, kCopies, near);
  const uint32_t between =
      (standing_with(kJoints, kCopies, far) - all_near) / (kCopies * (far.joints_b - 1));
  add_figure({{"guard", "fixed", "period"}}, none - kJoints * joint);
  add_figure({{"guard", "fixed", "joint"}}, joint);
  add_figure({{"guard", "fixed", "pair"}}, (all_near - none) / kCopies - between);
  add_figure({{"guard", "fixed", "between"}}, between);
}

void measure_standing() {
  Frame frames[kJoints];
  const JointCoordinate zeros[kJoints] = {};
  const uint32_t kinematics = port::instructions_of([&] { set_frames(robot, zeros, frames); });
  add_figure({{"guard", "kinematics"}}, kinematics);
  Guard guard(robot, guard_memory);
  const uint32_t fixed = standing(guard);
  add_figure({{"guard", "standing"}}, fixed);
  least_with_work = 2 * fixed + kinematics;
  guard.seal();
  measure({{"guard", "verify"}}, [&] { (void)guard.verify(); });
  add_figure({{"guard", "state"}}, sizeof guard_memory);
}

}  // namespace

bool measure_guard() {
  const bool opened = measure_opening();
  measure_standing();
  measure_fixed_part();
  const bool half = guard_motions("half", 50);
  const bool tenth = guard_motions("tenth", 10);
  const bool limited = limit_motions(50);
  return certify_motions() && opened && half && tenth && limited;
}

}  // namespace figures
