// The core's cycle counter as the instruction counter of insn.hpp. In QEMU a cycle is 25 ns.
#include "counter.hpp"

namespace port {
namespace {

__attribute__((always_inline)) inline uint32_t cycles() {
  uint32_t count;
  __asm__ volatile("rsr %0, ccount" : "=r"(count)::"memory");
  return count;
}

// Cycles of 100 instructions.
constexpr uint32_t kCycles =
    (uint32_t{1} << FLASHBVH_ICOUNT_SHIFT) * (FLASHBVH_CLOCK_KHZ / 1000) / 10;

}  // namespace

__attribute__((noinline)) uint32_t counted(Call function, void* context) {
  const uint32_t before = cycles();
  function(context);
  const uint32_t passed = cycles() - before;
  return passed / kCycles * 100 + (passed % kCycles * 100 + kCycles / 2) / kCycles;
}

const uint32_t kInstructionsPerPass = 2;

}  // namespace port

// port::empty(void*) and port::known_loop(void*). The compiler cannot omit a function's frame.
__asm__(
    ".text\n"
    ".align 4\n"
    ".global _ZN4port5emptyEPv\n"
    "_ZN4port5emptyEPv:\n"
    "  ret\n"
    ".align 4\n"
    ".global _ZN4port10known_loopEPv\n"
    "_ZN4port10known_loopEPv:\n"
    "1: addi a2, a2, -1\n"
    "  bnez a2, 1b\n"
    "  ret\n");
