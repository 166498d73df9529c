// Common to all boards: an arm's robot and servos, and the loop.
#pragma once

#include <flashbvh/robot/image.hpp>

#include "arm.hpp"
#include "servo_guard.hpp"

namespace servo {

constexpr uint32_t kServoCount = sizeof kServos / sizeof *kServos;
static_assert(kServoCount == ARM(VARIABLE_COUNT), "give each joint of the arm one servo");
static_assert(
    are_possible(kServos),
    "an id is below 254, an offset below 4096, a sign 1 or -1, a speed from 1 to 100000; no "
    "two servos have one id or joint");

inline flashbvh::Mesh meshes[ARM(LINK_COUNT)];
inline const flashbvh::Robot robot = flashbvh::view_robot_unchecked(ARM(robot_image), meshes);
inline flashbvh::GuardStateOf<ARM(JOINT_COUNT), ARM(PAIR_COUNT), ARM(PAIR_JOINT_COUNT)> state;

/// Sends bytes while the UART takes them.
template <class Bytes, class Uart>
void send(Bytes& bytes, Uart& uart) {
  while (!bytes.is_empty() && uart.can_write()) {
    uart.write(bytes.take());
  }
}

/// `board`: host, bus and text, UARTs with can_read(), read(), can_write(), write(byte), each
/// without waiting; listen(), after a packet on the bus; microseconds(); set_led(bool); times.
template <class Board>
[[noreturn]] void run(Board& board) {
  flashbvh::Guard guard(robot, state);
  static ServoGuard servos(robot, ARM(robot_image), guard, kServos, kServoCount, Board::times);
  for (;;) {
    servos.tick(board.microseconds());
    while (board.bus.can_read()) {
      servos.from_bus(board.bus.read());
    }
    if (servos.takes_host() && board.host.can_read()) {
      servos.from_host(board.host.read());
    }
    if (!servos.to_bus.is_empty()) {
      while (!servos.to_bus.is_empty()) {  // without a gap, which would end the packet
        send(servos.to_bus, board.bus);
      }
      board.listen();
    }
    send(servos.to_host, board.host);
    send(servos.text, board.text);
    board.set_led(servos.led());
  }
}

}  // namespace servo
