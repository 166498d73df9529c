// Lets a host move an arm's servos as far as no two links get too near each other.
//
// A forwarder between a host and a servo bus, by itself: bytes in and out, and the time as an
// argument. No UARTs, no heap, no floats. A board calls from_host() and from_bus() for each byte,
// tick() in its loop, and sends what is in to_bus, to_host and text.
#pragma once

#include <flashbvh/robot/image.hpp>

#include "packet.hpp"
#include "steps.hpp"

namespace servo {

/// A board's times.
struct Times {
  uint32_t silence = 5'000;  ///< after so long a servo does not answer, and a packet has ended
  uint32_t stale = 100'000;  ///< the age at which a position is unknown
};

/// Bytes in order; an interrupt's handler may put them. Those that don't fit are lost.
template <uint32_t size>
class Queue {
 public:
  uint32_t room() const { return size - 1 - (end_ + size - first_) % size; }
  bool is_empty() const { return first_ == end_; }
  void put(uint8_t byte) {
    if (room() != 0) {
      bytes_[end_] = byte;
      end_ = (end_ + 1) % size;
    }
  }
  uint8_t take() {
    const uint8_t byte = bytes_[first_];
    first_ = (first_ + 1) % size;
    return byte;
  }

 private:
  volatile uint8_t bytes_[size] = {};
  volatile uint32_t first_ = 0;
  volatile uint32_t end_ = 0;
};

class ServoGuard {
 public:
  Queue<1024> to_host;
  Queue<1024> to_bus;
  Queue<256> text;  ///< a line a second

  /// `image`: the robot's, for names. `servos`: one for each of the robot's variables, at most
  /// kMaxServos.
  ServoGuard(const flashbvh::Robot& robot, const void* image, flashbvh::Guard& guard,
             const Servo* servos, uint32_t count, const Times& times)
      : robot_(&robot), image_(image), steps_(robot, guard, servos, count), times_(times) {}

  State state() const { return steps_.state; }

  /// Whether from_host() takes a byte: not while a packet waits for an answer of the bus.
  bool takes_host() const { return !host_.has_packet(); }
  void from_host(uint8_t byte) {
    heard_at_ = now_;
    host_.push(byte);
    serve();
  }

  void from_bus(uint8_t byte) {
    bus_at_ = now_;
    awaited_ -= awaited_ != 0 ? 1 : 0;
    if (!is_own_) {
      to_host.put(byte);
    }
    bus_.push(byte);
    while (bus_.has_packet()) {
      take_answer(bus_.packet());
      bus_.drop_packet();
    }
  }

  /// `now`: microseconds, modulo 2^32.
  void tick(uint32_t now) {
    now_ = now;
    if (!host_.is_empty() && now - heard_at_ > times_.silence) {
      host_.give_up();
    }
    if (awaited_ != 0 && to_bus.is_empty() && now - bus_at_ > times_.silence) {
      awaited_ = 0;
      ++silences_;
    }
    serve();
    if (now - period_at_ >= kPeriod) {
      period_at_ = now;
      polls_ = steps_.count();
      steps_.period(now, times_.stale);
    }
    if (has_time_on_bus() && steps_.owes) {
      steps_.owes = false;
      send_goals(steps_.begin(), steps_.end());
    } else if (has_time_on_bus() && polls_ != 0) {
      --polls_;
      poll(steps_.begin()[next_poll_].servo.id);
      next_poll_ = (next_poll_ + 1) % steps_.count();
    }
    if (now - said_at_ >= 1'000'000) {
      said_at_ = now;
      say();
    }
  }

  /// On while goals pass; blinks fast while they are held, slowly while none passes.
  bool led() const {
    const uint32_t half = steps_.is_guarding() ? 100'000 : 500'000;
    return state() == State::free || now_ / half % 2 == 0;
  }

 private:
  // ---- packets of the host ----

  void serve() {
    // Room for the packet, and for goals before it.
    while (host_.has_packet() && !(is_own_ && awaited_ != 0) &&
           to_bus.room() >= 2 * kLargestPacket) {
      const Packet packet = host_.packet();
      const Writes writes = writes_of(packet);
      if (!handle(packet, writes)) {
        ++withheld_;
        last_withheld_[0] = packet.instruction();
        last_withheld_[1] = packet.parameter_count() != 0 ? packet.parameters()[0] : 0;
      }
      host_.drop_packet();
    }
  }

  /// False: it is withheld.
  bool handle(const Packet& packet, const Writes& writes) {
    switch (effect_of(packet, writes)) {
      case Effect::goal:
        return take_goals(packet, writes);
      case Effect::enable:
        return enable(packet, writes);
      case Effect::withheld:
        return false;
      case Effect::release:
        for (uint32_t i = 0; i < writes.servos; ++i) {
          steps_.find(writes.id(i))->is_loose = true;
        }
        break;
      case Effect::none:
        break;
    }
    send(packet, false);
    return true;
  }

  /// Whether all servos of the packet are the arm's, and their positions known.
  bool knows_all(const Writes& writes) {
    bool knows = true;
    for (uint32_t i = 0; i < writes.servos; ++i) {
      const Joint* const joint = steps_.find(writes.id(i));
      knows = knows && joint != steps_.end() && joint->is_known;
    }
    return knows;
  }

  /// The same packet, with the goals that are granted now.
  bool take_goals(const Packet& packet, const Writes& writes) {
    const uint32_t skipped = kGoal - writes.first;
    bool is_valid = steps_.is_guarding() && knows_all(writes);
    for (uint32_t i = 0; i < writes.servos; ++i) {
      is_valid = is_valid && writes.at(i)[skipped + 1] < kCounts / 256;
    }
    if (!is_valid) {
      return false;
    }
    ++goals_;
    for (uint32_t i = 0; i < writes.servos; ++i) {
      Joint& joint = *steps_.find(writes.id(i));
      joint.wanted = joint.at(number_at(writes.at(i) + skipped));
    }
    steps_.step();
    uint32_t addressed = 0;
    for (uint32_t i = 0; i < writes.servos; ++i) {
      const Joint& joint = *steps_.find(writes.id(i));
      put_number(writes.at(i) + skipped, joint.count_of(joint.sent));
      addressed |= 1u << joint.servo.variable;
    }
    send(sealed(packet.bytes, packet.size()), false);
    steps_.owes = steps_.owes && addressed != (1u << steps_.count()) - 1;
    return true;
  }

  /// Torque on: first the servo's goal becomes where it is.
  bool enable(const Packet& packet, const Writes& writes) {
    if (!knows_all(writes)) {
      return false;
    }
    for (uint32_t i = 0; i < writes.servos; ++i) {
      Joint& joint = *steps_.find(writes.id(i));
      joint.sent = joint.measured;
      joint.is_loose = false;
      joint.still = 0;
      steps_.stop(State::moving, joint);
      send_goals(&joint, &joint + 1);
    }
    send(packet, false);
    return true;
  }

  // ---- the bus ----

  /// Whether a packet of one's own may begin: no answer is due, and the host sends none, or has
  /// been sending for a period.
  bool has_time_on_bus() const {
    return awaited_ == 0 && to_bus.is_empty() &&
           (host_.is_empty() || (!host_.has_packet() && now_ - own_at_ > kPeriod));
  }

  /// Puts a packet on the bus. The host may send packets before earlier ones are answered.
  void send(const Packet& packet, bool is_own) {
    const bool is_sync = packet.instruction() == kSyncRead;
    const bool is_read = is_sync || packet.instruction() == kRead;
    const uint32_t count = packet.parameter_count();
    const uint32_t servos = is_sync && count >= 2
                                ? count - 2
                                : packet.id() != kBroadcast || packet.instruction() == kPing;
    awaited_ += servos * (is_read && count >= 2 ? packet.parameters()[1] + 6u : 6u);
    is_own_ = is_own;
    asked_ = packet.id();
    bus_.clear();
    for (uint32_t i = 0; i < packet.size(); ++i) {
      to_bus.put(packet.bytes[i]);
    }
    bus_at_ = now_;
    own_at_ = is_own ? now_ : own_at_;
  }

  void send_goals(const Joint* joint, const Joint* end) {
    uint8_t packet[8 + 3 * kMaxServos] = {0, 0, kBroadcast, 0, kSyncWrite, kGoal, 2};
    uint32_t size = 7;
    for (; joint != end; ++joint) {
      packet[size] = joint->servo.id;
      put_number(packet + size + 1, joint->count_of(joint->sent));
      size += 3;
    }
    send(sealed(packet, size + 1), true);
  }

  void poll(uint8_t id) {
    uint8_t packet[8] = {0, 0, id, 0, kRead, kPresent, 2};
    send(sealed(packet, sizeof packet), true);
  }

  void take_answer(const Packet& packet) {
    if (!is_own_ || packet.id() != asked_ || packet.parameter_count() != 2) {
      return;
    }
    const int32_t count = number_at(packet.parameters());
    if (count < kCounts) {  // more than a turn, or a direction: not known
      steps_.find(asked_)->measure(count, now_, steps_.owes);
    }
  }

  // ---- what it says ----

  void put(const char* words) {
    for (; *words != 0; ++words) {
      text.put(static_cast<uint8_t>(*words));
    }
  }

  void put(uint32_t number) {
    char digits[11] = {};
    char* first = digits + 10;
    do {
      *--first = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    put(first);
  }

  void say() {
    static const char* const kWords[] = {
        " is silent", " is loose", " moves", " is beyond its limits", "free", "held", "lagging"};
    if (!steps_.is_guarding()) {
      put("no goal passes: servo ");
      put(steps_.about);
    }
    put(kWords[static_cast<uint32_t>(state())]);
    if (state() == State::held && steps_.pair < robot_->pair_count) {
      put(" by ");
      put(flashbvh::link_name(image_, robot_->pairs[steps_.pair].a));
      put(" near ");
      put(flashbvh::link_name(image_, robot_->pairs[steps_.pair].b));
    }
    const struct {
      const char* words;
      uint32_t number;
    } parts[] = {{"; goals ", goals_},        {", shortened ", steps_.shortened},
                 {", withheld ", withheld_},  {" (instruction ", last_withheld_[0]},
                 {" at ", last_withheld_[1]}, {"), broken ", host_.broken + bus_.broken},
                 {", junk ", host_.skipped},  {", unanswered ", silences_}};
    for (const auto& part : parts) {
      put(part.words);
      put(part.number);
    }
    put("\n");
  }

  const flashbvh::Robot* robot_;
  const void* image_;
  Steps steps_;
  Times times_;
  Parser host_;
  Parser bus_;
  bool is_own_ = false;   ///< the last packet on the bus is this guard's
  uint8_t asked_ = 0;     ///< its id
  uint32_t awaited_ = 0;  ///< bytes of answers
  uint32_t next_poll_ = 0;
  uint32_t polls_ = 0;  ///< left in this period
  uint32_t now_ = 0;
  uint32_t period_at_ = 0;
  uint32_t said_at_ = 0;
  uint32_t heard_at_ = 0;  ///< the host
  uint32_t bus_at_ = 0;    ///< the last byte to the bus or from it
  uint32_t own_at_ = 0;    ///< the last packet of one's own
  uint32_t goals_ = 0;
  uint32_t withheld_ = 0;
  uint32_t silences_ = 0;
  uint8_t last_withheld_[2] = {};  ///< instruction and register
};

}  // namespace servo
