// Causes faults on Cortex-M.
#pragma once

#include <stdint.h>

inline void undefined_instruction() {
  __asm__ volatile("udf #0");
}

inline void leave_stack() {
  __asm__ volatile(
      "movs r0, #0\n"
      "mov sp, r0\n"
      "udf #0\n");
}

/// An even address selects the Arm instruction set, which the core does not have.
inline void branch_to(const volatile void* data) {
  __asm__ volatile("bx %0" ::"r"(data));
}

inline void pend(uint32_t interrupt_control_bit) {
  *reinterpret_cast<volatile uint32_t*>(0xE000ED04) = interrupt_control_bit;
  __asm__ volatile("dsb\n isb" ::: "memory");
}

/// Raises an interrupt whose handler faults.
inline void raise_handled() {
  pend(1U << 26);  // SysTick
}

inline void raise_unhandled() {
  pend(1U << 28);  // PendSV
}

extern "C" void SysTick_Handler() {
  undefined_instruction();
}
