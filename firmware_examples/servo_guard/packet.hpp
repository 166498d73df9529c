// Packets of FEETECH's STS and SMS servos, both ways:
//
//     FF FF, id, length, instruction or error, parameters, checksum
//
// `length` counts the instruction, the parameters and the checksum. The checksum is the complement
// of the sum from the id on. Numbers are little-endian.
//
// No heap, no time. Registers and instructions were compared in two sources: LeRobot's table of the
// STS series, after FEETECH's manual, and the header SMS_STS.h of FEETECH's own SDK. They agree,
// with one exception: that torque register 128 recalibrates stands in the SDK alone.
#pragma once

#include <stdint.h>

namespace servo {

enum Instruction : uint8_t {
  kPing = 1,
  kRead = 2,
  kWrite = 3,  // REG WRITE (4), ACTION (5), RECOVERY (6), RESET (10): withheld
  kSyncRead = 0x82,
  kSyncWrite = 0x83,
};

enum Register : uint8_t {
  kMode = 33,     ///< 0: positions; 1: speeds; 2: open loop; 3: steps
  kTorque = 40,   ///< 0: off; 1: on; 128: here is the middle
  kGoal = 42,     ///< goal position, 2 bytes; 44: its time, 46: its speed
  kGoalEnd = 48,  ///< the first register after the goal's speed
  kPresent = 56,  ///< present position, 2 bytes
};

constexpr uint8_t kBroadcast = 254;
constexpr uint32_t kLargestPacket = 4 + 255;

inline int32_t number_at(const uint8_t* bytes) {
  return bytes[0] | bytes[1] << 8;
}
inline void put_number(uint8_t* bytes, int32_t number) {
  bytes[0] = static_cast<uint8_t>(number);
  bytes[1] = static_cast<uint8_t>(number >> 8);
}

/// A whole packet, checked.
struct Packet {
  uint8_t* bytes;

  uint8_t id() const { return bytes[2]; }
  uint32_t size() const { return bytes[3] + 4u; }
  uint8_t instruction() const { return bytes[4]; }
  uint32_t parameter_count() const { return bytes[3] - 2u; }
  uint8_t* parameters() const { return bytes + 5; }
  uint8_t checksum() const {
    uint32_t sum = 0;
    for (uint32_t i = 2; i + 1 < size(); ++i) {
      sum += bytes[i];
    }
    return static_cast<uint8_t>(~sum);
  }
};

/// Writes a packet's header, length and checksum.
inline Packet sealed(uint8_t* bytes, uint32_t size) {
  bytes[0] = bytes[1] = 0xFF;
  bytes[3] = static_cast<uint8_t>(size - 4);
  const Packet packet = {bytes};
  bytes[size - 1] = packet.checksum();
  return packet;
}

/// Takes bytes one by one and finds packets in them. After a false header the search goes on behind
/// its first byte, so that no packet is lost to junk before it.
class Parser {
 public:
  uint32_t skipped = 0;  ///< bytes
  uint32_t broken = 0;   ///< packets with a wrong checksum

  /// Only while there is no packet.
  void push(uint8_t byte) {
    bytes_[size_++] = byte;
    search();
  }
  bool has_packet() const { return has_packet_; }
  bool is_empty() const { return size_ == 0; }
  Packet packet() { return {bytes_}; }
  void drop_packet() {
    remove(packet().size());
    search();
  }
  void clear() {
    size_ = 0;
    has_packet_ = false;
  }
  /// Takes what there is of an incomplete packet for junk.
  void give_up() {
    if (size_ != 0 && !has_packet_) {
      skip();
      search();
    }
  }

 private:
  void remove(uint32_t count) {
    size_ -= count;
    for (uint32_t i = 0; i < size_; ++i) {
      bytes_[i] = bytes_[i + count];
    }
    has_packet_ = false;
  }
  void skip() {
    ++skipped;
    remove(1);
  }
  void search() {
    while (size_ != 0 && !has_packet_) {
      const bool is_header = bytes_[0] == 0xFF && (size_ < 2 || bytes_[1] == 0xFF) &&
                             (size_ < 3 || bytes_[2] <= kBroadcast) &&
                             (size_ < 4 || bytes_[3] >= 2);
      if (is_header && (size_ < 4 || size_ < packet().size())) {
        return;
      }
      has_packet_ = is_header && bytes_[packet().size() - 1] == packet().checksum();
      broken += is_header && !has_packet_ ? 1 : 0;
      if (!has_packet_) {
        skip();
      }
    }
  }

  uint8_t bytes_[kLargestPacket];
  uint32_t size_ = 0;
  bool has_packet_ = false;
};

/// The data of a WRITE or a SYNC WRITE: so many bytes for each servo, from one register on.
struct Writes {
  uint8_t first = 0;      ///< register
  uint32_t bytes = 0;     ///< for each servo
  uint32_t servos = 0;    ///< 0: this is no such packet
  uint32_t distance = 0;  ///< to the next servo's
  const uint8_t* ids = nullptr;
  uint8_t* data = nullptr;

  uint8_t id(uint32_t i) const { return ids[i * distance]; }
  uint8_t* at(uint32_t i) const { return data + i * distance; }
};

inline Writes writes_of(const Packet& packet) {
  uint8_t* const parameters = packet.parameters();
  const uint32_t count = packet.parameter_count();
  if (packet.instruction() == kWrite && packet.id() != kBroadcast && count >= 2) {
    return {parameters[0], count - 1, 1, 0, packet.bytes + 2, parameters + 1};
  }
  if (packet.instruction() == kSyncWrite && packet.id() == kBroadcast && count >= 4) {
    const uint32_t distance = parameters[1] + 1u;
    if (distance > 1 && (count - 2) % distance == 0) {
      return {parameters[0], distance - 1,   (count - 2) / distance,
              distance,      parameters + 2, parameters + 3};
    }
  }
  return {};
}

/// The effect that a packet can have.
enum class Effect : uint8_t {
  none,      ///< moves nothing
  goal,      ///< sets goals, and maybe acceleration, time and speed with them
  enable,    ///< torque on, or the mode of positions: the servo goes to the goal that it has
  release,   ///< torque off
  withheld,  ///< could move a servo otherwise, or change what its positions mean, or is unknown
};

/// True if writing the register moves nothing and changes no position's meaning: delays, limits of
/// temperature, voltage, torque and current, gains, dead zones, acceleration, lock. All others
/// (id, baud rate, limits of positions, phase, resolution, offset, factory) do, or may.
constexpr bool is_harmless(uint32_t number) {
  return number == 7 || (number >= 13 && number < 18) || (number >= 19 && number < 30) ||
         (number >= 34 && number < 40) || number == 41 || number == 48 || number == 49 ||
         number == 55 || number == 85 || number == 86;
}

/// `writes`: the packet's.
inline Effect effect_of(const Packet& packet, const Writes& writes) {
  const uint8_t instruction = packet.instruction();
  if (instruction == kPing || instruction == kRead || instruction == kSyncRead) {
    return Effect::none;
  }
  if (writes.servos == 0) {
    return Effect::withheld;
  }
  const uint32_t end = writes.first + writes.bytes;
  if ((writes.first == kGoal || writes.first == kGoal - 1) && end > kGoal + 1 && end % 2 == 0 &&
      end <= kGoalEnd) {
    return Effect::goal;
  }
  const uint8_t value = *writes.at(0);
  bool is_one_value = writes.bytes == 1;
  for (uint32_t i = 0; i < writes.servos; ++i) {
    is_one_value = is_one_value && *writes.at(i) == value;
  }
  if (is_one_value && writes.first == kTorque && value < 2) {
    return value == 1 ? Effect::enable : Effect::release;
  }
  if (is_one_value && writes.first == kMode && value == 0) {
    return Effect::enable;
  }
  bool is_none = true;
  for (uint32_t number = writes.first; number < end; ++number) {
    is_none = is_none && is_harmless(number);
  }
  return is_none ? Effect::none : Effect::withheld;
}

}  // namespace servo
