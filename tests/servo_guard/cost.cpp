// The instructions of a packet in the servo guard, from its last byte to its first one on the bus:
// all that from_host() executes. Servos answer at once, and are late in their ways.
#include "insn.hpp"
#include "run.hpp"
#include "support/random.hpp"
#include "text.hpp"

using namespace servo;

namespace {

int32_t at[kServoCount];     // in 1/16 count
int32_t goals[kServoCount];  // in counts

/// The reaction of servos to a packet of the guard.
void answer(ServoGuard& guard, const Packet& packet) {
  const Writes writes = writes_of(packet);
  for (uint32_t i = 0; i < kServoCount; ++i) {
    for (uint32_t k = 0; k < writes.servos; ++k) {
      goals[i] = writes.id(k) == kServos[i].id ? number_at(writes.at(k)) : goals[i];
    }
    if (packet.instruction() == kRead && packet.id() == kServos[i].id) {
      uint8_t reply[8] = {0, 0, packet.id()};
      put_number(reply + 5, at[i] / 16);
      sealed(reply, sizeof reply);
      for (const uint8_t byte : reply) {
        guard.from_bus(byte);
      }
    }
  }
}

/// Empties the bus.
void answer(ServoGuard& guard, Parser& bus) {
  while (!guard.to_bus.is_empty()) {
    bus.push(guard.to_bus.take());
    for (; bus.has_packet(); bus.drop_packet()) {
      answer(guard, bus.packet());
    }
  }
}

struct Cost {
  const char* name;
  uint32_t most = 0;
  uint64_t sum = 0;
  uint32_t count = 0;

  void add(uint32_t instructions) {
    most = instructions > most ? instructions : most;
    sum += instructions;
    ++count;
  }
};

}  // namespace

int main() {
  flashbvh::Guard limits(robot, state);
  static ServoGuard guard(robot, ARM(robot_image), limits, kServos, kServoCount, Times{});
  static Parser bus;
  flashbvh::test::Random random(1);
  uint8_t read[8] = {0, 0, kServos[0].id, 0, kRead, 62, 3};
  uint8_t write[8 + 3 * kServoCount] = {0, 0, kBroadcast, 0, kSyncWrite, kGoal, 2};
  for (uint32_t i = 0; i < kServoCount; ++i) {
    at[i] = 16 * (goals[i] = kServos[i].offset);
    write[7 + 3 * i] = kServos[i].id;
  }
  const Packet packets[] = {sealed(read, sizeof read), {write}};
  Cost costs[] = {{"moves nothing"}, {"goals"}};
  for (uint32_t step = 0; step < 60'000; ++step) {  // of 0.1 ms
    guard.tick(100 * step);
    answer(guard, bus);
    for (uint32_t i = 0; i < kServoCount; ++i) {
      const int32_t way = (16 * goals[i] - at[i]) / static_cast<int32_t>(200 << i % 2);
      at[i] += way != 0 ? way : goals[i] * 16 > at[i] ? 1 : goals[i] * 16 < at[i] ? -1 : 0;
      if (step % 10'000 == 1000) {
        put_number(write + 8 + 3 * i, random.between(0, kCounts - 1));
      }
    }
    if (step < 1000 || step % 100 != 0) {
      continue;
    }
    sealed(write, sizeof write);
    const Packet& packet = packets[step / 100 % 2];
    const uint32_t last = packet.size() - 1;
    for (uint32_t i = 0; i < last; ++i) {
      guard.from_host(packet.bytes[i]);
    }
    const bool was_empty = guard.to_bus.is_empty();
    costs[step / 100 % 2].add(port::instructions_of([&] { guard.from_host(packet.bytes[last]); }));
    if (!was_empty || guard.to_bus.is_empty()) {
      return 1;
    }
    answer(guard, bus);
  }
  for (const Cost& cost : costs) {
    port::print(cost.name, ": ", cost.count, " packets, ",
                static_cast<uint32_t>(cost.sum / cost.count), " instructions in the mean, ",
                cost.most, " at most\n");
  }
  return guard.state() >= State::free ? 0 : 1;
}
