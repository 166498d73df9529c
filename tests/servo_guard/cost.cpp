// The instructions of a packet in the servo guard, from its last byte to its first one on the bus:
// all that from_host() executes. Servos answer at once, and are late in their ways. Packets that
// move nothing come out as they are, in that call.
#include <flashbvh/robot/image.hpp>

#include "arm.hpp"
#include "insn.hpp"
#include "servo_guard.hpp"
#include "support/random.hpp"
#include "text.hpp"

using namespace servo;

namespace {

constexpr uint32_t kServoCount = sizeof kServos / sizeof *kServos;

flashbvh::Mesh meshes[ARM(LINK_COUNT)];
flashbvh::GuardStateOf<ARM(JOINT_COUNT), ARM(PAIR_COUNT), ARM(PAIR_JOINT_COUNT)> state;
int32_t at[kServoCount];  // in 1/16 count
int32_t goals[kServoCount];

/// Servos answer what is on the bus.
void answer(ServoGuard& guard, Parser& bus) {
  while (!guard.to_bus.is_empty()) {
    bus.push(guard.to_bus.take());
    while (bus.has_packet()) {
      const Packet packet = bus.packet();
      const Writes writes = writes_of(packet);
      for (uint32_t i = 0; i < kServoCount; ++i) {
        for (uint32_t k = 0; k < writes.servos; ++k) {
          const uint8_t* const goal = packet.bytes + writes.at(k);
          goals[i] = writes.id(packet, k) == kServos[i].id ? goal[0] + goal[1] * 256 : goals[i];
        }
        if (packet.instruction() == kRead && packet.id() == kServos[i].id) {
          const int32_t count = at[i] / 16;
          uint8_t reply[8] = {0, 0, packet.id()};
          reply[5] = static_cast<uint8_t>(count);
          reply[6] = static_cast<uint8_t>(count >> 8);
          seal(reply, sizeof reply);
          for (const uint8_t byte : reply) {
            guard.from_bus(byte);
          }
        }
      }
      bus.drop_packet();
    }
  }
}

struct Cost {
  uint32_t most = 0;
  uint64_t sum = 0;
  uint32_t count = 0;

  void add(uint32_t instructions) {
    most = instructions > most ? instructions : most;
    sum += instructions;
    ++count;
  }
  void print(const char* name) const {
    port::print(name, ": ", count, " packets, ", static_cast<uint32_t>(sum / count),
                " instructions in the mean, ", most, " at most\n");
  }
};

}  // namespace

int main() {
  const flashbvh::Robot robot = flashbvh::view_robot_unchecked(ARM(robot_image), meshes);
  flashbvh::Guard limits(robot, state);
  static ServoGuard guard(robot, ARM(robot_image), limits, kServos, Times{});
  static Parser bus;
  flashbvh::test::Random random(1);
  for (uint32_t i = 0; i < kServoCount; ++i) {
    at[i] = 16 * (goals[i] = kServos[i].offset);
  }
  Cost goal;
  Cost read;
  bool is_same = true;
  uint32_t now = 0;
  int32_t wanted[kServoCount] = {};
  for (uint32_t step = 0; step < 60'000; ++step) {  // of 0.1 ms
    guard.tick(now += 100);
    answer(guard, bus);
    for (uint32_t i = 0; i < kServoCount; ++i) {
      const int32_t way = (16 * goals[i] - at[i]) / static_cast<int32_t>(200 << i % 2);
      at[i] += way != 0 ? way : goals[i] * 16 > at[i] ? 1 : goals[i] * 16 < at[i] ? -1 : 0;
      wanted[i] = step % 10'000 == 1000 ? random.between(0, kCounts - 1) : wanted[i];
    }
    if (step < 1000 || step % 100 != 0) {
      continue;
    }
    const bool is_read = step % 200 == 0;
    uint8_t packet[8 + 3 * kServoCount] = {0, 0, kServos[0].id, 0, kRead, 62, 3};
    uint32_t size = 8;
    if (!is_read) {
      packet[2] = kBroadcast;
      packet[4] = kSyncWrite;
      packet[5] = kGoal;
      packet[6] = 2;
      for (uint32_t i = 0; i < kServoCount; ++i) {
        packet[7 + 3 * i] = kServos[i].id;
        packet[8 + 3 * i] = static_cast<uint8_t>(wanted[i]);
        packet[9 + 3 * i] = static_cast<uint8_t>(wanted[i] >> 8);
      }
      size = sizeof packet;
    }
    seal(packet, size);
    for (uint32_t i = 0; i + 1 < size; ++i) {
      guard.from_host(packet[i]);
    }
    is_same = is_same && guard.to_bus.is_empty();
    (is_read ? read : goal).add(port::instructions_of([&] { guard.from_host(packet[size - 1]); }));
    for (uint32_t i = 0; is_read && i < size; ++i) {
      is_same = is_same && !guard.to_bus.is_empty() && guard.to_bus.take() == packet[i];
    }
    answer(guard, bus);
  }
  read.print("moves nothing");
  goal.print("goals");
  return is_same && guard.state() >= State::free ? 0 : 1;
}
