// The servo guard on QEMU's mps2-an386: the host at UART 0, the bus at UART 1, text at UART 2.
// Without interrupts: QEMU's UARTs keep a byte until it is read, and bytes before it wait outside.
#include "clock.hpp"
#include "run.hpp"

namespace {

struct Registers {
  uint32_t data;
  uint32_t state;  ///< bit 0: cannot write; bit 1: can read
  uint32_t control;
  uint32_t interrupt;
  uint32_t divisor;
};

struct Uart {
  explicit Uart(uintptr_t address) : at(reinterpret_cast<volatile Registers*>(address)) {
    at->divisor = 25;  // 1 Mbit/s
    at->control = 3;
  }
  bool can_read() const { return (at->state & 2) != 0; }
  uint8_t read() const { return static_cast<uint8_t>(at->data); }
  bool can_write() const { return (at->state & 1) == 0; }
  void write(uint8_t byte) const { at->data = byte; }

  volatile Registers* at;
};

struct Board {
  Uart host{0x40004000};
  Uart bus{0x40005000};
  Uart text{0x40006000};

  uint32_t microseconds() { return clock.microseconds(); }
  void listen() {}
  static void set_led(bool is_on) {
    *reinterpret_cast<volatile uint32_t*>(0x40028000) = is_on ? 1 : 0;
  }

  /// QEMU's bus is a program on a busy machine.
  static constexpr servo::Times times = {100'000, 1'000'000};
  servo::Clock<25> clock;
};

}  // namespace

int main() {
  Board board;
  servo::run(board);
}
