// The goals that an arm's servos are sent: steps that the guard grants.
//
// A step is of at most the servos' speed a period. limit() proves it from the goals of the last
// one, so servos have to be there: a step is sent if all servos are within kNear of the last goals,
// or if the guard proves the box of all values between the last readings and all goals since, which
// servos that move evenly don't leave.
//
// While any position is unknown, stale, or of a servo without torque, there are no steps: servos
// keep their goals. When all stand still the guard starts again from where they are, and makes that
// their goals. So it also does for servos that stand still farther than kMoved from their goals.
#pragma once

#include <flashbvh/robot/guard.hpp>

namespace servo {

using flashbvh::JointCoordinate;
using flashbvh::Status;

constexpr uint32_t kPeriod = 5'000;                      ///< in microseconds, as all times
constexpr int32_t kCounts = 4096;                        ///< of a turn
constexpr JointCoordinate kCount = (1 << 28) / kCounts;  ///< a count's coordinate
constexpr int32_t kNear = kCount;        ///< from its goal, at most, of a servo that arrived
constexpr int32_t kSlack = 3 * kCount;   ///< beyond a joint's limits, that is taken for the limit
constexpr int32_t kMoved = 64 * kCount;  ///< from its goal, at least, of a servo that won't
constexpr uint8_t kStill = 10;           ///< readings of a servo that stands still
constexpr uint8_t kStalled = 100;        ///< readings of a servo that gave up its goal
constexpr uint32_t kWork = 500;          ///< of each call to the guard, in units of query.hpp
constexpr uint32_t kMaxServos = 16;

inline int32_t least(int32_t a, int32_t b) {
  return a < b ? a : b;
}
inline int32_t most(int32_t a, int32_t b) {
  return a < b ? b : a;
}
inline int32_t clipped(int32_t value, int32_t low, int32_t high) {
  return most(low, least(value, high));
}
/// Down to a whole count.
inline JointCoordinate whole(JointCoordinate at) {
  return at & ~(kCount - 1);
}

/// A servo, as an arm's file lists it.
struct Servo {
  uint8_t variable;  ///< of the robot
  uint8_t id;
  int32_t offset;  ///< the count at the joint's zero
  int32_t sign;    ///< 1, or -1: counts grow as the joint's value falls
  int32_t speed;   ///< counts a second, at most
};

/// Whether servos' numbers are possible, and no id or variable has two.
template <uint32_t count>
constexpr bool are_possible(const Servo (&servos)[count]) {
  bool are = count <= kMaxServos;
  for (uint32_t i = 0; i < count; ++i) {
    const Servo& servo = servos[i];
    are = are && servo.id < 254 && servo.offset >= 0 && servo.offset < kCounts &&
          servo.sign * servo.sign == 1 && servo.speed > 0 && servo.speed <= 100'000;
    for (uint32_t j = 0; j < i; ++j) {
      are = are && servo.id != servos[j].id && servo.variable != servos[j].variable;
    }
  }
  return are;
}

/// A servo and its joint: coordinates of whole counts.
struct Joint {
  Servo servo;
  JointCoordinate lowest;  ///< limits
  JointCoordinate highest;
  JointCoordinate measured;
  JointCoordinate anchor;  ///< measured when it moved last
  JointCoordinate wanted;
  JointCoordinate sent;  ///< the goal
  JointCoordinate next;  ///< the next goal, granted
  JointCoordinate low;   ///< where it may be
  JointCoordinate high;
  uint32_t measured_at;
  uint8_t still;  ///< readings near the anchor
  bool is_known;
  bool is_loose;

  JointCoordinate at(int32_t count) const { return servo.sign * (count - servo.offset) * kCount; }
  int32_t count_of(JointCoordinate at) const { return servo.offset + servo.sign * (at / kCount); }
  JointCoordinate off(JointCoordinate goal) const { return most(goal - measured, measured - goal); }

  void limit(const flashbvh::RobotJoint& of) {
    lowest = least(at(0), at(kCounts - 1));
    highest = most(at(0), at(kCounts - 1));
    if (of.type != flashbvh::JointType::continuous) {
      lowest = most(lowest, -whole(-of.lower));
      highest = least(highest, whole(of.upper));
    }
  }
  /// `adds`: the servo may still go where it was sent before.
  void measure(int32_t count, uint32_t now, bool adds) {
    measured = at(count);
    const bool has_moved = !is_known || off(anchor) > 2 * kCount;
    anchor = has_moved ? measured : anchor;
    still = static_cast<uint8_t>(has_moved ? 0 : least(still + 1, 255));
    measured_at = now;
    is_known = true;
    low = least(least(measured, sent), adds ? low : measured);
    high = most(most(measured, sent), adds ? high : measured);
  }
};

enum class State : uint8_t {
  silent,   ///< a servo's position is not known
  loose,    ///< a servo has no torque
  moving,   ///< a servo moves, so the guard can't start
  refused,  ///< the guard refuses the positions: a joint is beyond its limits
  free,     ///< goals pass
  held,     ///< goals are shortened
  lagging,  ///< goals wait for a servo
};

class Steps {
 public:
  bool owes = false;  ///< goals are not on the bus yet
  State state = State::silent;
  uint8_t about = 0;                  ///< the id of the servo that `state` is about
  uint32_t shortened = 0;             ///< steps
  uint16_t pair = flashbvh::kNoPair;  ///< that shortened the last one

  /// `servos`: one for each of the robot's variables, at most kMaxServos.
  Steps(const flashbvh::Robot& robot, flashbvh::Guard& guard, const Servo* servos, uint32_t count)
      : guard_(&guard), count_(count) {
    for (uint32_t i = 0; i < count; ++i) {
      joints_[servos[i].variable].servo = servos[i];
    }
    for (uint32_t i = 0; i < robot.joint_count; ++i) {
      if (robot.joints[i].shift == 0) {
        joints_[robot.joints[i].variable].limit(robot.joints[i]);
      }
    }
  }

  Joint* begin() { return joints_; }
  Joint* end() { return joints_ + count_; }
  uint32_t count() const { return count_; }
  /// The joint of a servo; end() if it is not the arm's.
  Joint* find(uint8_t id) {
    Joint* joint = begin();
    while (joint != end() && joint->servo.id != id) {
      ++joint;
    }
    return joint;
  }
  bool is_guarding() const { return is_guarding_; }

  void stop(State why, const Joint& joint) {
    is_guarding_ = is_pending_ = owes = false;
    state = why;
    about = joint.servo.id;
  }

  /// Every kPeriod. `stale`: the age at which a position is unknown.
  void period(uint32_t now, uint32_t stale) {
    ++periods_;
    bool are_still = true;
    bool is_off = false;
    for (Joint& joint : *this) {
      joint.is_known = joint.is_known && now - joint.measured_at <= stale;
      if (!joint.is_known || joint.is_loose) {
        joint.still = 0;
        return stop(joint.is_loose ? State::loose : State::silent, joint);
      }
      is_off = is_off || joint.off(joint.sent) > kMoved;
      if (joint.still < (is_guarding_ ? kStalled : kStill)) {
        are_still = false;
        about = joint.servo.id;
      }
    }
    if (are_still && (!is_guarding_ || is_off)) {
      return start();
    }
    if (!is_guarding_) {
      state = State::moving;
      return;
    }
    step();
    has_stepped_ = false;
    owes = owes || (periods_ % 32 == 0 && !is_near());  // a packet may have been lost
  }

  /// The next goals, if the servos may have them yet. Only the first time in a period.
  void step() {
    if (has_stepped_) {
      return;
    }
    has_stepped_ = true;
    if (!is_pending_) {
      find_next();
    }
    if (!is_pending_) {
      return;
    }
    if (!is_near() && !is_box_free()) {
      state = State::lagging;
      return;
    }
    for (Joint& joint : *this) {
      joint.sent = joint.next;
      joint.low = least(joint.low, joint.sent);
      joint.high = most(joint.high, joint.sent);
    }
    is_pending_ = false;
    owes = true;
  }

 private:
  /// From where the servos are.
  void start() {
    JointCoordinate values[kMaxServos];
    for (Joint& joint : *this) {
      joint.sent = joint.wanted = clipped(joint.measured, joint.lowest, joint.highest);
      if (joint.off(joint.sent) > kSlack) {
        return stop(State::refused, joint);
      }
      joint.low = least(joint.sent, joint.measured);
      joint.high = most(joint.sent, joint.measured);
      joint.still = 0;
      values[joint.servo.variable] = joint.sent;
    }
    if (guard_->prime(values).status != Status::done) {
      return stop(State::refused, joints_[0]);
    }
    is_guarding_ = owes = true;
    is_pending_ = false;
    state = State::free;
  }

  bool is_near() {
    bool is = true;
    for (const Joint& joint : *this) {
      is = is && joint.low >= joint.sent - kNear && joint.high <= joint.sent + kNear;
    }
    return is;
  }

  /// Whether all pairs keep their stop distances, or get no deeper, wherever the servos go now.
  bool is_box_free() {
    JointCoordinate from[kMaxServos];
    JointCoordinate to[kMaxServos];
    for (const Joint& joint : *this) {  // a count more, as a reading is rounded
      const JointCoordinate low = least(joint.low, joint.next) - kCount;
      const JointCoordinate high = most(joint.high, joint.next) + kCount;
      from[joint.servo.variable] = clipped(low, joint.lowest, joint.highest);
      to[joint.servo.variable] = clipped(high, joint.lowest, joint.highest);
    }
    if (guard_->update(from, kWork).status != Status::done) {
      return false;
    }
    const flashbvh::GuardAnswer answer = guard_->update(to, kWork);
    return answer.status == Status::done && answer.verdict <= flashbvh::Verdict::leaving;
  }

  void find_next() {
    JointCoordinate target[kMaxServos];
    JointCoordinate granted[kMaxServos];
    bool is_there = true;
    for (const Joint& joint : *this) {
      const int32_t step =
          (joint.servo.speed / static_cast<int32_t>(1'000'000 / kPeriod) + 1) * kCount;
      const JointCoordinate wanted = clipped(joint.wanted, joint.lowest, joint.highest);
      const JointCoordinate next = clipped(wanted, joint.sent - step, joint.sent + step);
      is_there = is_there && next == joint.sent;
      target[joint.servo.variable] = next;
    }
    state = State::free;
    if (is_there) {
      return;
    }
    const flashbvh::LimitAnswer answer = guard_->limit(target, granted, kWork);
    if (answer.status != Status::done) {
      return stop(State::refused, joints_[0]);
    }
    if (answer.verdict != flashbvh::LimitVerdict::granted) {
      state = State::held;
      ++shortened;
      pair = answer.pair;
    }
    for (Joint& joint : *this) {
      // Coordinates a turn apart are equal.
      const uint32_t moved =
          static_cast<uint32_t>(granted[joint.servo.variable]) - static_cast<uint32_t>(joint.sent);
      joint.next = joint.sent + whole(static_cast<int32_t>(moved << 4) / 16 + kCount / 2);
      is_pending_ = is_pending_ || joint.next != joint.sent;
    }
  }

  flashbvh::Guard* guard_;
  uint32_t count_;
  Joint joints_[kMaxServos + 1] = {};  ///< by variables; the last one: of no servo
  bool is_guarding_ = false;
  bool has_stepped_ = false;  ///< in this period
  bool is_pending_ = false;   ///< `next` is granted and not sent
  uint32_t periods_ = 0;
};

}  // namespace servo
