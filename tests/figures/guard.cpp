// The guard of the KR5 at 1 kHz: 20 s of motion at half of the joints' top speed and at a tenth,
// and motions certified. Ends with 1 if a period on a certified motion is told to stop.
#include "flashbvh/robot/guard.hpp"

#include "insn.hpp"
#include "kr5_arm.robot.hpp"
#include "motions.hpp"
#include "report.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20261121;
constexpr uint32_t kPeriods = 20000;
constexpr uint32_t kMotions = 64;
/// Granted each period.
constexpr uint32_t kWork = 680;

constexpr uint32_t kJoints = kr5_arm::kJointCount;
using MotionState = MotionStateOf<kr5_arm::kVariableCount, kJoints>;

// 375, 300, 375, 410, 410 and 660 degrees a second.
constexpr TopSpeeds<kJoints> kTop = {279620, 223696, 279620, 305719, 305719, 492132};

kr5_arm::GuardState guard_memory;
MotionState motion_memory;

/// Instructions of many periods: mean, most, and what 999 of 1,000 stay below.
class Periods {
 public:
  void add(uint32_t instructions) {
    spread_.add(instructions);
    const uint32_t bucket = instructions / kWidth;
    ++buckets_[bucket < kBuckets ? bucket : kBuckets - 1];
  }
  uint32_t thousandth() const {
    uint32_t above = 0;
    uint32_t bucket = kBuckets;
    while (bucket != 0 && above + buckets_[bucket - 1] <= spread_.count() / 1000) {
      above += buckets_[--bucket];
    }
    return bucket * kWidth;
  }
  const Spread& spread() const { return spread_; }

 private:
  static constexpr uint32_t kWidth = 500;
  static constexpr uint32_t kBuckets = 600;
  Spread spread_;
  uint16_t buckets_[kBuckets] = {};
};

/// Returns whether no period was told to stop.
bool guard_motions(const char* name, uint32_t percent) {
  Motions<MotionState, kJoints> motions(kr5_arm::robot, motion_memory, kTop, percent, kSeed);
  Guard guard(kr5_arm::robot, guard_memory);
  bool good = guard.prime(motions.values()).verdict == Verdict::free;
  Periods periods;
  Spread work;
  uint32_t unknown = 0;
  for (uint32_t i = 0; i < kPeriods; ++i) {
    motions.next();
    GuardAnswer answer = {};
    periods.add(port::instructions_of([&] { answer = guard.update(motions.values(), kWork); }));
    work.add(answer.work);
    counted.add(answer.work);
    counted.add(static_cast<uint32_t>(answer.verdict));
    good = good && answer.status == Status::done && answer.verdict != Verdict::stop;
    unknown += answer.verdict == Verdict::not_yet_known ? 1 : 0;
  }
  print_figures({{"guard", name}}, periods.spread());
  print_figure({{"guard", name, "thousandth"}}, periods.thousandth());
  print_counts({{"guard", "work", name}}, work);
  print_count({{"guard", "unknown", name}}, unknown);
  return good;
}

/// Each joint moves by up to 1 radian; those that are free. Returns whether some are.
bool certify_motions() {
  constexpr int32_t radian = 42722830;
  test::Random random(kSeed);
  MotionQuery query(kr5_arm::robot, motion_memory);
  JointCoordinate from[kJoints];
  JointCoordinate to[kJoints];
  Spread spread;
  for (uint32_t i = 0; i < kMotions; ++i) {
    for (uint32_t j = 0; j < kJoints; ++j) {
      const RobotJoint& joint = kr5_arm::robot.joints[j];
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
      spread.add(instructions);
    }
  }
  print_figures({{"motion", "free"}}, spread);
  counted.add(spread.count());
  return spread.count() != 0;
}

bool run() {
  print_core();
  Frame frames[kJoints];
  const JointCoordinate zeros[kJoints] = {};
  print_figure({{"guard", "kinematics"}},
               port::instructions_of([&] { set_frames(kr5_arm::robot, zeros, frames); }));
  Guard guard(kr5_arm::robot, guard_memory);
  (void)guard.prime(zeros);
  print_figure({{"guard", "standing"}},
               port::instructions_of([&] { (void)guard.update(zeros, kWork); }));
  print_figure({{"guard", "state"}}, sizeof guard_memory);
  const bool good = guard_motions("half", 50) && guard_motions("tenth", 10) && certify_motions();
  print_count({{"guard", "digest"}}, counted.value());
  return good;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::run() ? 0 : 1;
}
