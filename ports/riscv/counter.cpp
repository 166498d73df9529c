// The core's own instruction counter as that of insn.hpp.
#include "counter.hpp"

namespace port {
namespace {

__attribute__((always_inline)) inline uint32_t retired() {
  uint32_t count;
  __asm__ volatile(
      ".option push\n"
      ".option arch, +zicsr\n"
      "csrr %0, minstret\n"
      ".option pop\n"
      : "=r"(count)::"memory");
  return count;
}

}  // namespace

__attribute__((noinline)) uint32_t counted(Call function, void* context) {
  const uint32_t before = retired();
  function(context);
  return retired() - before;
}

__attribute__((naked)) void empty(void*) {
  __asm__ volatile("ret");
}

const uint32_t kInstructionsPerPass = 2;

__attribute__((naked)) void known_loop(void*) {
  __asm__ volatile(
      "1: addi a0, a0, -1\n"
      "  bnez a0, 1b\n"
      "  ret\n");
}

}  // namespace port
