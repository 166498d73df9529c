// SysTick as the instruction counter of insn.hpp. It has 24 bits; its interrupt counts the wraps.
#include "counter.hpp"
#include "systick.hpp"

extern "C" {
volatile uint32_t port_systick_wraps;

// In assembler, so that it executes kHandlerInstructions on every core and at every optimisation.
__attribute__((naked)) void SysTick_Handler() {
  __asm__ volatile(
      ".syntax unified\n"
      "  ldr r0, =port_systick_wraps\n"
      "  ldr r1, [r0]\n"
      "  adds r1, r1, #1\n"
      "  str r1, [r0]\n"
      "  bx lr\n"
      "  .ltorg\n");
}
}

namespace port {
namespace {

constexpr uint32_t kHandlerInstructions = 5;

constexpr uint32_t kLargestReload = 0xFFFFFF;

// Not inlined, so that the code around a call adds a constant.
__attribute__((noinline)) void run_counted(Call function, void* context) {
  port_systick_wraps = 0;
  systick().control = kStop;
  systick().reload = kLargestReload;
  systick().current = 0;
  systick().control = kCount;
  function(context);
  systick().control = kStop;
  // The interrupt of a wrap at the very end must be taken before port_systick_wraps is read.
  __asm__ volatile("dsb\n isb" ::: "memory");
}

// Virtual time of a wrap, rounded down, as QEMU starts each wrap at a whole nanosecond.
constexpr uint64_t kNanosecondsPerWrap =
    (uint64_t{kLargestReload} + 1) * 1000000 / FLASHBVH_CLOCK_KHZ;

}  // namespace

uint32_t counted(Call function, void* context) {
  run_counted(function, context);
  const uint64_t wraps = port_systick_wraps;
  const uint64_t ticks = (0 - systick().current) & kLargestReload;
  const uint64_t nanoseconds = wraps * kNanosecondsPerWrap + ticks * 1000000 / FLASHBVH_CLOCK_KHZ;
  constexpr uint64_t kHalf = (uint64_t{1} << FLASHBVH_ICOUNT_SHIFT) / 2;
  const uint64_t instructions = (nanoseconds + kHalf) >> FLASHBVH_ICOUNT_SHIFT;
  return static_cast<uint32_t>(instructions - wraps * kHandlerInstructions);
}

__attribute__((naked)) void empty(void*) {
  __asm__ volatile("bx lr");
}

const uint32_t kInstructionsPerPass = 3;

__attribute__((naked)) void known_loop(void*) {
  __asm__ volatile(
      ".syntax unified\n"
      "1: subs r0, r0, #1\n"
      "  cmp r0, #0\n"
      "  bne 1b\n"
      "  bx lr\n");
}

}  // namespace port
