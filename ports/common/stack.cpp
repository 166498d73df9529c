#include "stack.hpp"

#include "start.hpp"

namespace port {
namespace {

constexpr uint32_t kPaint = 0xA5A5A5A5;

// Paints from the stack's limit to the stack pointer and returns the stack pointer.
//
// Inlined, as a frame of its own would lie in the painted area. In assembler, because the compiler
// may move the stack pointer between any two statements. It clobbers the return address, so that
// the caller sets up its frame before.
__attribute__((always_inline)) inline uint32_t* paint_below_frame() {
  uint32_t* word = __stack_limit;
  uint32_t* top;
#if defined(__riscv)
  __asm__ volatile(
      "  mv %[top], sp\n"
      "1: sw %[paint], 0(%[word])\n"
      "  addi %[word], %[word], 4\n"
      "  bltu %[word], %[top], 1b\n"
      : [top] "=&r"(top), [word] "+r"(word)
      : [paint] "r"(kPaint)
      : "ra", "memory");
#else
  __asm__ volatile(
      ".syntax unified\n"
      "  mov %[top], sp\n"
      "1: str %[paint], [%[word]]\n"
      "  adds %[word], #4\n"
      "  cmp %[word], %[top]\n"
      "  blo 1b\n"
      : [top] "=&l"(top), [word] "+l"(word)
      : [paint] "l"(kPaint)
      : "cc", "lr", "memory");
#endif
  return top;
}

// Inlined, as a frame of its own would be counted.
__attribute__((always_inline)) inline uint32_t used_below(uint32_t* top) {
  const volatile uint32_t* word = __stack_limit;
  while (word < top && *word == kPaint) {
    ++word;
  }
  return static_cast<uint32_t>(top - word) * sizeof(uint32_t);
}

}  // namespace

uint32_t stack_size() {
  return static_cast<uint32_t>(__stack_top - __stack_limit) * sizeof(uint32_t);
}

uint32_t static_bytes() {
  return static_cast<uint32_t>(__bss_end - __data_start) * sizeof(uint32_t);
}

uint32_t stack_used() {
  return used_below(__stack_top);
}

__attribute__((noinline)) void paint_stack() {
  paint_below_frame();
}

__attribute__((noinline)) uint32_t stack_of_call(Call function, void* context) {
  uint32_t* const top = paint_below_frame();
  function(context);
  return used_below(top);
}

}  // namespace port
