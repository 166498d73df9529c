// Tests stack_of() on frames of known size.
#include "stack.hpp"

#include "checks.hpp"

namespace {

// Pushes 2 words, `context` times.
__attribute__((naked)) void push_pairs(void*) {
  __asm__ volatile(
#if defined(__riscv)
      "  mv a1, sp\n"
      "1: addi sp, sp, -8\n"
      "  sw a0, 0(sp)\n"
      "  sw a0, 4(sp)\n"
      "  addi a0, a0, -1\n"
      "  bnez a0, 1b\n"
      "  mv sp, a1\n"
      "  ret\n"
#else
      ".syntax unified\n"
      "  mov r1, sp\n"
      "1: push {r0, r1}\n"
      "  subs r0, r0, #1\n"
      "  bne 1b\n"
      "  mov sp, r1\n"
      "  bx lr\n"
#endif
  );
}

volatile uint32_t in_data[50] = {1};
volatile uint32_t in_bss[50];

void expect_pairs(uint32_t pairs) {
  const uint32_t bytes = port::stack_of_call(push_pairs, reinterpret_cast<void*>(pairs));
  expect("pairs of words", bytes, 8 * pairs);
}

// Writes every byte of a frame of 400 bytes; saved registers are added to it.
void fill_frame() {
  volatile uint8_t frame[400];
  for (volatile uint8_t& byte : frame) {
    byte = 1;
  }
}

}  // namespace

int main() {
  expect("nothing", port::stack_of([] {}), 0);
  for (uint32_t pairs = 1; pairs <= 100; ++pairs) {
    expect_pairs(pairs);
  }
  expect("a frame", port::stack_of(fill_frame), 400, 440);
  port::paint_stack();
  const uint32_t before = port::stack_used();
  fill_frame();
  expect("a frame after another", port::stack_used() - before, 300, 480);
  in_bss[0] = in_data[0];
  expect("static bytes", port::static_bytes(), 400, 1000);
  return end_checks();
}
