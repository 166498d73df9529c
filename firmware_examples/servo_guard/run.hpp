// What all boards have in common: an arm's robot and servos, and the loop. arm.hpp is written by
// arm.py.
#pragma once

#include <flashbvh/robot/image.hpp>

#include "arm.hpp"
#include "servo_guard.hpp"

namespace servo {

inline flashbvh::Mesh meshes[ARM(LINK_COUNT)];
inline const flashbvh::Robot robot = flashbvh::view_robot_unchecked(ARM(robot_image), meshes);
inline flashbvh::GuardStateOf<ARM(JOINT_COUNT), ARM(PAIR_COUNT), ARM(PAIR_JOINT_COUNT)> state;

/// Bytes from an interrupt's handler to the loop. Those that don't fit are lost.
class Ring {
 public:
  void put(uint8_t byte) {
    const uint32_t next = (end_ + 1) % sizeof bytes_;
    if (next != begin_) {
      bytes_[end_] = byte;
      end_ = next;
    }
  }
  bool is_empty() const { return begin_ == end_; }
  uint8_t take() {
    const uint8_t byte = bytes_[begin_];
    begin_ = (begin_ + 1) % sizeof bytes_;
    return byte;
  }

 private:
  volatile uint8_t bytes_[1024] = {};
  volatile uint32_t begin_ = 0;
  volatile uint32_t end_ = 0;
};

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
  static ServoGuard servos(robot, ARM(robot_image), guard, kServos, Board::times);
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
