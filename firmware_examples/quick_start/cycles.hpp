// The core's own counter of cycles.
#pragma once

#include <stdint.h>

/// Cycles since any moment, modulo 2^32; always 0 on a core without a counter, as a Cortex-M0 or
/// QEMU's Cortex-M.
inline uint32_t core_cycles() {
#if defined(__arm__) && __ARM_ARCH_ISA_THUMB == 2 && !defined(__ARM_ARCH_ISA_ARM)
  *reinterpret_cast<volatile uint32_t*>(0xE000EDFC) |= 1u << 24;  // DEMCR: trace on
  *reinterpret_cast<volatile uint32_t*>(0xE0001000) |= 1;         // DWT: count
  return *reinterpret_cast<volatile uint32_t*>(0xE0001004);
#elif defined(__riscv)
  uint32_t count;
  __asm__ volatile(".option push\n .option arch, +zicsr\n csrr %0, mcycle\n .option pop\n"
                   : "=r"(count)::"memory");
  return count;
#else
  return 0;
#endif
}
