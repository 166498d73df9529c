// Tests wait states of flash by the profiles of ports/cycles/tables/flash.csv: the RP2040's on a
// Cortex-M0, the STM32F4's on other cores.
#include <stdint.h>

#include "checks.hpp"
#include "cycles.hpp"

namespace {

// 128 bytes: eight lines of 16, or sixteen of 8.
#define CODE(name, text)                                                       \
  __attribute__((naked, aligned(128))) void name(void*) {                      \
    __asm__ volatile(".syntax unified\n" text "\n nop\n bx lr\n .balign 128"); \
  }
CODE(narrow, ".rept 62\n nop\n .endr")
#if __ARM_ARCH >= 7
CODE(wide, ".rept 31\n add.w r1, r1, #1\n .endr")
#endif

// Reads a, b, a and c, 8 KB apart, twice. The RP2040's two ways keep two of them: in the second
// round, each read of a hits.
CODE(far,
     "movs r1, #1\n lsls r1, r1, #13\n adds r1, r0, r1\n movs r2, #1\n lsls r2, r2, #14\n"
     "adds r2, r0, r2\n .rept 2\n ldr r3, [r0]\n nop\n ldr r3, [r1]\n nop\n ldr r3, [r0]\n nop\n"
     "ldr r3, [r2]\n nop\n .endr")

/// Expects that the first call waits, and that a later call, with a warm cache, takes `cycles`.
void expect_call(const char* name, port::Call code, uint32_t cycles, uint32_t first_waits) {
  void* const flash = reinterpret_cast<void*>(0x1000);
  expect(name, port::cycles_of_call(code, flash), cycles + first_waits);
  expect(name, port::cycles_of_call(code, flash), cycles);
}

}  // namespace

int main() {
#if __ARM_ARCH >= 7
  // Executing a line of eight instructions takes longer than reading a line; four take less.
  expect_call("narrow", narrow, 63, 5);
  expect_call("wide", wide, 32, 5 + 7 * 2);
  expect_call("far", far, 31, 5 + 3 * 5);
#else
  constexpr uint32_t kMiss = 56;
  expect_call("narrow", narrow, 63, 16 * kMiss);
  expect_call("far", far, 31 + 4 * kMiss, (6 + 1) * kMiss);
#endif
  return end_checks();
}
