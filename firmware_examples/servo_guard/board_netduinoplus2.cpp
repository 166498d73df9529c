// The servo guard on an STM32F405, whose registers it names by address: the host at USART 1 (PA9,
// PA10), the bus on the one wire PA2 of USART 2, text at USART 3 (PB10), the LED at PD12.
// QEMU's netduinoplus2 runs it; no real one has.
#include "clock.hpp"
#include "run.hpp"

namespace {

volatile uint32_t& at(uintptr_t address) {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

constexpr uintptr_t kClocks = 0x40023800;
constexpr uint32_t kOn = 1u << 13 | 1u << 5 | 1u << 3;  // enable, interrupt of bytes, send
constexpr uint32_t kReceive = 1u << 2;

struct Usart {
  Usart(uintptr_t address, uint32_t clock) : registers(address) {
    at(registers + 0x08) = clock / 1'000'000;  // 1 Mbit/s
    at(registers + 0x0C) = kOn | kReceive;
  }
  bool can_read() const { return !bytes.is_empty(); }
  uint8_t read() { return bytes.take(); }
  bool can_write() const { return (at(registers) & 1u << 7) != 0; }
  void write(uint8_t byte) const { at(registers + 4) = byte; }
  void interrupt() { bytes.put(static_cast<uint8_t>(at(registers + 4))); }

  uintptr_t registers;
  servo::Queue<1024> bytes;
};

/// A bus of one wire hears itself unless it is deaf while it sends.
struct Bus : Usart {
  using Usart::Usart;
  void write(uint8_t byte) const {
    at(registers + 0x0C) = kOn;
    Usart::write(byte);
  }
};

/// 168 MHz from the 16 MHz of the chip itself. QEMU's clock is so anyway, and never ready.
void start_clock() {
  at(0x40023C00) = 0x705;                                  // caches, 5 wait states
  at(kClocks + 0x04) = 16 | 336 << 6 | 0 << 16 | 7 << 24;  // 16 MHz / 16 * 336 / 2
  at(kClocks + 0x00) = at(kClocks + 0x00) | 1u << 24;
  for (int i = 0; i < 100'000 && (at(kClocks + 0x00) & 1u << 25) == 0; ++i) {
  }
  at(kClocks + 0x08) = 2 | 5u << 10 | 4u << 13;         // buses at 42 and 84 MHz
  at(kClocks + 0x30) = at(kClocks + 0x30) | 1 | 2 | 8;  // ports A, B, D
  at(kClocks + 0x40) = at(kClocks + 0x40) | 1u << 17 | 1u << 18;
  at(kClocks + 0x44) = at(kClocks + 0x44) | 1u << 4;
  at(0x40020000) = at(0x40020000) | 2u << 4 | 2u << 18 | 2u << 20;  // PA2, PA9, PA10
  at(0x40020004) = at(0x40020004) | 1u << 2;                        // the wire is pulled up
  at(0x40020020) = at(0x40020020) | 7u << 8;
  at(0x40020024) = at(0x40020024) | 7u << 4 | 7u << 8;
  at(0x40020400) = at(0x40020400) | 2u << 20;  // PB10
  at(0x40020424) = at(0x40020424) | 7u << 8;
  at(0x40020C00) = at(0x40020C00) | 1u << 24;  // PD12
}

struct Board {
  Usart host{0x40011000, 84'000'000};
  Bus bus{0x40004400, 42'000'000};
  Usart text{0x40004800, 42'000'000};

  Board() {
    at(bus.registers + 0x14) = 1u << 3;  // one wire
  }
  uint32_t microseconds() { return clock.microseconds(); }
  void listen() const {
    while ((at(bus.registers) & 1u << 6) == 0) {
    }
    at(bus.registers + 0x0C) = kOn | kReceive;
  }
  static void set_led(bool is_on) { at(0x40020C18) = is_on ? 1u << 12 : 1u << 28; }

#ifdef SERVO_GUARD_SLOW_BUS  // a program on a busy machine
  static constexpr servo::Times times = {100'000, 1'000'000};
#else
  static constexpr servo::Times times = {};
#endif
  servo::Clock<168> clock;
};

Board* board;
void (*vectors[16 + 40])() __attribute__((aligned(256)));

}  // namespace

int main() {
  start_clock();
  static Board all;
  board = &all;
  for (uint32_t i = 0; i < 16; ++i) {  // the start-up's, and three more
    vectors[i] = reinterpret_cast<void (**)()>(at(0xE000ED08))[i];
  }
  vectors[16 + 37] = [] { board->host.interrupt(); };
  vectors[16 + 38] = [] { board->bus.interrupt(); };
  vectors[16 + 39] = [] { board->text.interrupt(); };
  at(0xE000ED08) = reinterpret_cast<uintptr_t>(vectors);
  at(0xE000E104) = 7u << 5;
  servo::run(all);
}
