// Painting the unused stack, on Cortex-M.
#ifndef FLASHBVH_PORT_PAINT_HPP
#define FLASHBVH_PORT_PAINT_HPP

#include <stdint.h>

#include "start.hpp"

namespace port {

constexpr uint32_t kPaint = 0xA5A5A5A5;

/// Paints from the stack's limit to the stack pointer and returns the stack pointer.
///
/// Inlined, or there would be a frame of its own in the painted area; in assembler, because the
/// compiler may move the stack pointer between any two statements. That it clobbers lr makes the
/// caller set up its frame before.
__attribute__((always_inline)) inline uint32_t* paint_below_frame() {
  uint32_t* word = __stack_limit;
  uint32_t* top;
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
  return top;
}

}  // namespace port

#endif
