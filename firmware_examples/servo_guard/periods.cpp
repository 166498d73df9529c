// The periods: what servos are sent, and what the guard says.
#include "servo_guard.hpp"

#include <flashbvh/robot/image.hpp>

#include "counts.hpp"

namespace servo {

using namespace flashbvh;

void ServoGuard::tick(uint32_t now) {
  now_ = now;
  if (!host_.is_empty() && now - heard_at_ > times_.silence) {
    host_.give_up();
  }
  if (awaited_ != 0 && to_bus.is_empty() && now - bus_at_ > times_.silence) {
    awaited_ = 0;
    ++silences_;
    while (!bus_.is_empty()) {
      bus_.give_up();
      while (bus_.has_packet()) {
        bus_.drop_packet();
      }
    }
  }
  serve();
  if (now - period_at_ >= kPeriod) {
    period_at_ = now;
    period();
  }
  if (has_time_on_bus()) {
    if (owes_) {
      owes_ = false;
      send_goals((1u << count_) - 1);
    } else if (polls_ != 0) {
      poll();
    }
  }
  if (now - said_at_ >= 1'000'000) {
    said_at_ = now;
    say();
  }
}

void ServoGuard::stop(State state, uint32_t i) {
  is_guarding_ = false;
  is_pending_ = false;
  owes_ = false;
  state_ = state;
  about_ = servos_[i].id;
}

void ServoGuard::period() {
  ++periods_;
  polls_ = count_;
  bool are_still = true;
  bool is_off = false;
  for (uint32_t i = 0; i < count_; ++i) {
    const Joint& joint = joints_[i];
    if (!is_fresh(joint) || joint.is_loose) {
      joints_[i].still = 0;
      joints_[i].is_known = is_fresh(joint);
      return stop(joint.is_loose ? State::loose : State::silent, i);
    }
    is_off = is_off || apart(joint.measured, joint.sent) > kMoved;
    if (joint.still < (is_guarding_ ? kStalled : kStill)) {
      are_still = false;
      about_ = servos_[i].id;
    }
  }
  if (are_still && (!is_guarding_ || is_off)) {
    return start();
  }
  if (!is_guarding_) {
    state_ = State::moving;
    return;
  }
  if (!has_stepped_) {
    step();
  }
  has_stepped_ = false;
  owes_ = owes_ || (periods_ % 32 == 0 && !is_near());  // a packet may have been lost
}

/// From where the servos are.
void ServoGuard::start() {
  JointCoordinate values[kMaxServos];
  for (uint32_t i = 0; i < count_; ++i) {
    Joint& joint = joints_[i];
    joint.sent = joint.wanted = clipped(joint.measured, joint.lowest, joint.highest);
    if (apart(joint.sent, joint.measured) > kSlack) {
      return stop(State::refused, i);
    }
    joint.low = least(joint.sent, joint.measured);
    joint.high = most(joint.sent, joint.measured);
    joint.still = 0;
    values[servos_[i].variable] = coordinate(i, joint.sent);
  }
  if (guard_->prime(values).status != Status::done) {
    return stop(State::refused, 0);
  }
  is_guarding_ = owes_ = true;
  is_pending_ = false;
  state_ = State::free;
}

bool ServoGuard::is_near() const {
  bool is = true;
  for (uint32_t i = 0; i < count_; ++i) {
    const Joint& joint = joints_[i];
    is = is && joint.low >= joint.sent - kNear && joint.high <= joint.sent + kNear;
  }
  return is;
}

/// Whether all pairs keep their stop distances, or get no deeper, wherever the servos go now.
bool ServoGuard::is_box_free() {
  JointCoordinate from[kMaxServos];
  JointCoordinate to[kMaxServos];
  for (uint32_t i = 0; i < count_; ++i) {
    const Joint& joint = joints_[i];
    const int32_t low = least(joint.low, joint.next) - 1;  // a reading is rounded
    const int32_t high = most(joint.high, joint.next) + 1;
    from[servos_[i].variable] = coordinate(i, clipped(low, joint.lowest, joint.highest));
    to[servos_[i].variable] = coordinate(i, clipped(high, joint.lowest, joint.highest));
  }
  if (guard_->update(from, kWork).status != Status::done) {
    return false;
  }
  const GuardAnswer answer = guard_->update(to, kWork);
  return answer.status == Status::done && answer.verdict <= Verdict::leaving;
}

/// The next goals, if the servos may have them yet.
void ServoGuard::step() {
  has_stepped_ = true;
  if (!is_pending_) {
    JointCoordinate target[kMaxServos];
    JointCoordinate granted[kMaxServos];
    bool is_there = true;
    for (uint32_t i = 0; i < count_; ++i) {
      const Joint& joint = joints_[i];
      const int32_t step = servos_[i].speed / static_cast<int32_t>(1'000'000 / kPeriod) + 1;
      const int32_t wanted = clipped(joint.wanted, joint.lowest, joint.highest);
      const int32_t next = clipped(wanted, joint.sent - step, joint.sent + step);
      is_there = is_there && next == joint.sent;
      target[servos_[i].variable] = coordinate(i, next);
    }
    if (is_there) {
      state_ = State::free;
      return;
    }
    const LimitAnswer answer = guard_->limit(target, granted, kWork);
    if (answer.status != Status::done) {
      return stop(State::refused, 0);
    }
    state_ = answer.verdict == LimitVerdict::granted ? State::free : State::held;
    shortened_ += state_ == State::held ? 1 : 0;
    pair_ = answer.pair;
    for (uint32_t i = 0; i < count_; ++i) {
      Joint& joint = joints_[i];
      // Coordinates a turn apart are equal.
      const auto moved = static_cast<uint32_t>(granted[servos_[i].variable]) -
                         static_cast<uint32_t>(coordinate(i, joint.sent));
      const int32_t way = static_cast<int32_t>(moved << 4) / 16;
      joint.next = joint.sent + servos_[i].sign * ((way + kCount / 2) >> 16);
      is_pending_ = is_pending_ || joint.next != joint.sent;
    }
  }
  if (!is_pending_) {
    return;
  }
  if (!is_near() && !is_box_free()) {
    state_ = State::lagging;
    return;
  }
  for (uint32_t i = 0; i < count_; ++i) {
    Joint& joint = joints_[i];
    joint.sent = joint.next;
    joint.low = least(joint.low, joint.sent);
    joint.high = most(joint.high, joint.sent);
  }
  is_pending_ = false;
  owes_ = true;
}

// ---- what it says ----

bool ServoGuard::led() const {
  const uint32_t half = is_guarding_ ? 100'000 : 500'000;
  return state_ == State::free || now_ / half % 2 == 0;
}

void ServoGuard::put(const char* words) {
  for (; *words != 0; ++words) {
    text.put(static_cast<uint8_t>(*words));
  }
}

void ServoGuard::put(uint32_t number) {
  char digits[11] = {};
  char* first = digits + 10;
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  put(first);
}

void ServoGuard::say() {
  static const char* const kWords[] = {" is silent", " is loose", " moves", " is beyond its limits",
                                       "free",       "held",      "lagging"};
  if (!is_guarding_) {
    put("no goal passes: servo ");
    put(about_);
  }
  put(kWords[static_cast<uint32_t>(state_)]);
  if (state_ == State::held && pair_ < robot_->pair_count) {
    put(" by ");
    put(link_name(image_, robot_->pairs[pair_].a));
    put(" near ");
    put(link_name(image_, robot_->pairs[pair_].b));
  }
  const struct {
    const char* words;
    uint32_t number;
  } parts[] = {{"; goals ", goals_},        {", shortened ", shortened_},
               {", withheld ", withheld_},  {" (instruction ", last_withheld_[0]},
               {" at ", last_withheld_[1]}, {"), broken ", host_.broken + bus_.broken},
               {", junk ", host_.skipped},  {", unanswered ", silences_}};
  for (const auto& part : parts) {
    put(part.words);
    put(part.number);
  }
  put("\n");
}

}  // namespace servo
