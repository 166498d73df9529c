// Reset and traps of a RISC-V core, which runs in machine mode throughout.
#include <stdint.h>

#include "semihosting.hpp"
#include "start.hpp"
#include "text.hpp"

extern "C" {
void Reset_Handler();
void Trap_Handler();
void Unexpected_Handler();
// A program replaces it by defining a function of this name. It must not return: the stack is new.
void Interrupt_Handler(uint32_t cause);

// The first instruction of the image.
__attribute__((naked, used, section(".vectors"))) void Reset_Handler() {
  __asm__ volatile(
      ".option push\n"
      ".option norelax\n"
      "  la gp, __global_pointer$\n"
      ".option pop\n"
      "  la sp, __stack_top\n"
      "  la t0, Trap_Handler\n"
      ".option push\n"
      ".option arch, +zicsr\n"
      "  csrw mtvec, t0\n"
      ".option pop\n"
      "  call port_reset\n");
}

[[noreturn]] __attribute__((used)) void port_reset() {
  port::start_program();
}

// A fault may leave an unusable stack, so the handler resets the stack pointer.
__attribute__((naked, used, aligned(4))) void Trap_Handler() {
  __asm__ volatile(
      "  la sp, __stack_top\n"
      ".option push\n"
      ".option arch, +zicsr\n"
      "  csrr a0, mcause\n"
      ".option pop\n"
      "  call port_trap\n");
}

[[noreturn]] __attribute__((used)) void port_trap(uint32_t cause) {
  constexpr uint32_t kInterrupt = 1U << 31;
  if ((cause & kInterrupt) != 0) {
    Interrupt_Handler(cause & ~kInterrupt);
  }
  port::put("\n[port] fault\n");
  port::exit_program(port::kExitFault);
}

void Unexpected_Handler() {
  port::put("\n[port] unexpected interrupt\n");
  port::exit_program(port::kExitUnexpectedInterrupt);
}

__attribute__((weak)) void Interrupt_Handler(uint32_t) {
  Unexpected_Handler();
}
}
