// Causes faults on RISC-V.
#pragma once

#include <stdint.h>

extern "C" void Unexpected_Handler();

inline void undefined_instruction() {
#ifdef __riscv_compressed
  __asm__ volatile("unimp");
#else
  __asm__ volatile(".half 1, 1");  // c.nop, which the emulated core must refuse, too
#endif
}

inline void leave_stack() {
  __asm__ volatile(
      "li sp, 0\n"
      "unimp\n");
}

/// Two zero bytes are an illegal instruction.
inline void branch_to(const volatile void* data) {
  __asm__ volatile("jr %0" ::"r"(data));
}

constexpr uint32_t kSoftwareInterrupt = 3;
constexpr uint32_t kTimerInterrupt = 7;

inline void enable(uint32_t interrupt) {
  __asm__ volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "  csrs mie, %0\n"
      "  csrsi mstatus, 8\n"
      ".option pop\n" ::"r"(1 << interrupt)
      : "memory");
}

// The core-local interruptor has one address on both machines.

/// Raises an interrupt whose handler faults.
inline void raise_handled() {
  *reinterpret_cast<volatile uint32_t*>(0x02000000) = 1;
  enable(kSoftwareInterrupt);
}

inline void raise_unhandled() {
  volatile uint32_t* const timer_compare = reinterpret_cast<volatile uint32_t*>(0x02004000);
  timer_compare[0] = 0;
  timer_compare[1] = 0;
  enable(kTimerInterrupt);
  for (;;) {  // the timer need not have ticked yet
  }
}

extern "C" void Interrupt_Handler(uint32_t cause) {
  if (cause == kSoftwareInterrupt) {
    undefined_instruction();
  }
  Unexpected_Handler();
}
