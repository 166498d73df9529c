// Causes faults on Xtensa.
#pragma once

#include <stdint.h>

extern "C" void Unexpected_Handler();

inline void undefined_instruction() {
  __asm__ volatile("ill");
}

inline void leave_stack() {
  __asm__ volatile(
      "movi sp, 0\n"
      "s32i a2, sp, 0\n"
      "ill\n");
}

/// Three zero bytes are an illegal instruction.
inline void branch_to(const volatile void* data) {
  __asm__ volatile("jx %0" ::"r"(data));
}

/// True if the only interrupt that a program can raise by itself has a handler.
inline volatile bool has_handler = false;

inline void raise() {
  constexpr uint32_t kSoftwareInterrupt = 1 << 7;
  __asm__ volatile(
      "wsr %0, intenable\n"
      "wsr %0, intset\n"
      "rsync" ::"r"(kSoftwareInterrupt)
      : "memory");
}

/// Raises an interrupt whose handler faults.
inline void raise_handled() {
  has_handler = true;
  raise();
}

inline void raise_unhandled() {
  raise();
}

extern "C" void Interrupt_Handler(uint32_t /*pending*/) {
  if (has_handler) {
    undefined_instruction();
  }
  Unexpected_Handler();
}
