// The streams: packets of the host, and answers of the bus.
#include "servo_guard.hpp"

#include "counts.hpp"

namespace servo {

using namespace flashbvh;

ServoGuard::ServoGuard(const Robot& robot, const void* image, Guard& guard, const Servo* servos,
                       const Times& times)
    : robot_(&robot), image_(image), guard_(&guard), servos_(servos), times_(times), count_(0) {
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    count_ += robot.joints[i].shift == 0 ? 1 : 0;
  }
  for (uint32_t i = 0; i < count_; ++i) {
    const Servo& servo = servos[i];
    joints_[i].highest = kCounts - 1;
    for (uint32_t j = 0; j < robot.joint_count; ++j) {
      const RobotJoint& joint = robot.joints[j];
      if (joint.shift != 0 || joint.variable != servo.variable ||
          joint.type == JointType::continuous) {
        continue;
      }
      const int32_t lower = servo.sign > 0 ? joint.lower : -joint.upper;
      const int32_t upper = servo.sign > 0 ? joint.upper : -joint.lower;
      joints_[i].lowest = most(0, servo.offset - (-lower >> 16));
      joints_[i].highest = least(kCounts - 1, servo.offset + (upper >> 16));
    }
  }
}

uint32_t ServoGuard::find(uint8_t id) const {
  uint32_t i = 0;
  while (i < count_ && servos_[i].id != id) {
    ++i;
  }
  return i;
}

bool ServoGuard::is_fresh(const Joint& joint) const {
  return joint.is_known && now_ - joint.measured_at <= times_.stale;
}

JointCoordinate ServoGuard::coordinate(uint32_t i, int32_t count) const {
  return servos_[i].sign * (count - servos_[i].offset) * kCount;
}

// ---- packets of the host ----

void ServoGuard::from_host(uint8_t byte) {
  heard_at_ = now_;
  host_.push(byte);
  serve();
}

/// Whether a packet of one's own may begin: no answer is due, and the host sends none, or has been
/// sending for a period.
bool ServoGuard::has_time_on_bus() const {
  return awaited_ == 0 && to_bus.is_empty() &&
         (host_.is_empty() || (!host_.has_packet() && now_ - own_at_ > kPeriod));
}

void ServoGuard::serve() {
  // Room for the packet, and for goals before it.
  while (host_.has_packet() && !(is_own_ && awaited_ != 0) && to_bus.room() >= 2 * kLargestPacket) {
    handle(host_.packet());
    host_.drop_packet();
  }
}

void ServoGuard::handle(const Packet& packet) {
  const Writes writes = writes_of(packet);
  switch (effect_of(packet)) {
    case Effect::none:
      request(packet);
      forward(packet.bytes, packet.size());
      break;
    case Effect::goal:
      take_goals(packet, writes);
      break;
    case Effect::enable:
      enable(packet, writes);
      break;
    case Effect::release:
      for (uint32_t i = 0; i < writes.servos; ++i) {
        joints_[find(writes.id(packet, i))].is_loose = true;
      }
      request(packet);
      forward(packet.bytes, packet.size());
      break;
    case Effect::withheld:
      withhold(packet);
      break;
  }
}

void ServoGuard::withhold(const Packet& packet) {
  ++withheld_;
  last_withheld_[0] = packet.instruction();
  last_withheld_[1] = packet.parameter_count() != 0 ? packet.parameters()[0] : 0;
}

void ServoGuard::forward(const uint8_t* bytes, uint32_t size) {
  for (uint32_t i = 0; i < size; ++i) {
    to_bus.put(bytes[i]);
  }
  bus_at_ = now_;
}

/// Notes what the answers to a packet of the host will be.
void ServoGuard::request(const Packet& packet) {
  const uint8_t* const parameters = packet.parameters();
  const bool is_sync = packet.instruction() == kSyncRead;
  const bool is_read = packet.instruction() == kRead || is_sync;
  asked_ = packet.id();
  first_ = is_read && packet.parameter_count() >= 2 ? parameters[0] : 0;
  bytes_ = is_read && packet.parameter_count() >= 2 ? parameters[1] : 0;
  const uint32_t servos = is_sync ? packet.parameter_count() - 2
                                  : packet.id() != kBroadcast || packet.instruction() == kPing;
  awaited_ = servos < 255 ? servos * (bytes_ + 6u) : 0;
  is_own_ = false;
  is_old_ = false;
}

/// Sends some servos their goals. `servos`: a bit each.
void ServoGuard::send_goals(uint32_t servos) {
  uint8_t packet[8 + 3 * kMaxServos] = {0, 0, kBroadcast, 0, kSyncWrite, kGoal, 2};
  uint32_t size = 7;
  for (uint32_t i = 0; i < count_; ++i) {
    if ((servos >> i & 1) != 0) {
      packet[size++] = servos_[i].id;
      packet[size++] = static_cast<uint8_t>(joints_[i].sent);
      packet[size++] = static_cast<uint8_t>(joints_[i].sent >> 8);
    }
  }
  seal(packet, ++size);
  is_old_ = true;
  forward(packet, size);
  own_at_ = now_;
}

/// Whether all servos of the packet are the arm's, and their positions known.
bool ServoGuard::knows_all(const Packet& packet, const Writes& writes) const {
  bool knows = true;
  for (uint32_t i = 0; i < writes.servos; ++i) {
    const uint32_t servo = find(writes.id(packet, i));
    knows = knows && servo < count_ && is_fresh(joints_[servo]);
  }
  return knows;
}

/// The same packet, with the goals that are granted now.
void ServoGuard::take_goals(const Packet& packet, const Writes& writes) {
  const uint32_t skipped = kGoal - writes.first;
  const auto goal_at = [&](uint32_t i) { return writes.at(i) + skipped; };
  bool is_valid = is_guarding_ && knows_all(packet, writes);
  for (uint32_t i = 0; i < writes.servos; ++i) {
    is_valid = is_valid && packet.bytes[goal_at(i) + 1] < kCounts / 256;
  }
  if (!is_valid) {
    withhold(packet);
    return;
  }
  ++goals_;
  uint32_t addressed = 0;
  for (uint32_t i = 0; i < writes.servos; ++i) {
    const uint32_t servo = find(writes.id(packet, i));
    const uint8_t* const goal = packet.bytes + goal_at(i);
    joints_[servo].wanted = goal[0] + goal[1] * 256;
    addressed |= 1u << servo;
  }
  if (!has_stepped_) {
    step();
  }
  uint8_t changed[kLargestPacket];
  for (uint32_t i = 0; i < packet.size(); ++i) {
    changed[i] = packet.bytes[i];
  }
  for (uint32_t i = 0; i < writes.servos; ++i) {
    const int32_t sent = joints_[find(writes.id(packet, i))].sent;
    changed[goal_at(i)] = static_cast<uint8_t>(sent);
    changed[goal_at(i) + 1] = static_cast<uint8_t>(sent >> 8);
  }
  seal(changed, packet.size());
  request(packet);
  is_old_ = true;
  forward(changed, packet.size());
  owes_ = owes_ && addressed != (1u << count_) - 1;
}

/// Torque on: first the servo's goal becomes where it is.
void ServoGuard::enable(const Packet& packet, const Writes& writes) {
  if (!knows_all(packet, writes)) {
    withhold(packet);
    return;
  }
  uint32_t addressed = 0;
  for (uint32_t i = 0; i < writes.servos; ++i) {
    const uint32_t servo = find(writes.id(packet, i));
    Joint& joint = joints_[servo];
    joint.sent = joint.measured;
    joint.is_loose = false;
    joint.still = 0;
    addressed |= 1u << servo;
  }
  stop(State::moving, 0);
  send_goals(addressed);
  request(packet);
  is_old_ = true;
  forward(packet.bytes, packet.size());
}

// ---- answers of the bus ----

void ServoGuard::from_bus(uint8_t byte) {
  bus_at_ = now_;
  awaited_ -= awaited_ != 0 ? 1 : 0;
  if (!is_own_) {
    to_host.put(byte);
  }
  bus_.push(byte);
  while (bus_.has_packet()) {
    answer(bus_.packet());
    bus_.drop_packet();
  }
}

void ServoGuard::poll() {
  const uint8_t id = servos_[next_poll_].id;
  uint8_t packet[8] = {0, 0, id, 0, kRead, kPresent, 2};
  seal(packet, sizeof packet);
  request({packet});
  forward(packet, sizeof packet);
  is_own_ = true;
  own_at_ = now_;
  next_poll_ = (next_poll_ + 1) % count_;
  --polls_;
}

void ServoGuard::answer(const Packet& packet) {
  const uint32_t servo = find(packet.id());
  const bool is_asked = asked_ == packet.id() || asked_ == kBroadcast;
  if (servo < count_ && is_asked && packet.parameter_count() == bytes_ && first_ <= kPresent &&
      first_ + bytes_ >= kPresent + 2) {
    const uint8_t* const position = packet.parameters() + (kPresent - first_);
    measure(joints_[servo], position[0] + position[1] * 256);
  }
}

void ServoGuard::measure(Joint& joint, int32_t count) {
  if (count >= kCounts) {
    return;  // more than a turn, or a direction: not known
  }
  const bool has_moved = !joint.is_known || apart(count, joint.anchor) > 2;
  joint.anchor = has_moved ? count : joint.anchor;
  joint.still = static_cast<uint8_t>(has_moved ? 0 : least(joint.still + 1, 255));
  joint.measured = count;
  joint.measured_at = now_;
  joint.is_known = true;
  // A servo may still go where it was sent before.
  const bool adds = owes_ || is_old_;
  joint.low = least(least(count, joint.sent), adds ? joint.low : count);
  joint.high = most(most(count, joint.sent), adds ? joint.high : count);
}

}  // namespace servo
