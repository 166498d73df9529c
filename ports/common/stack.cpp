#include "stack.hpp"

#include "start.hpp"

namespace port {
namespace {

constexpr uint32_t kPaint = 0xA5A5A5A5;

// Inlined, or there would be a frame of its own below the one that it is to find.
__attribute__((always_inline)) inline uint32_t* stack_pointer() {
  uint32_t* pointer;
  __asm__ volatile("mov %0, sp" : "=r"(pointer));
  return pointer;
}

// Volatile keeps the compiler from calling memset(), whose frame would lie in the painted area.
__attribute__((always_inline)) inline void paint_below(uint32_t* top) {
  for (volatile uint32_t* word = __stack_limit; word < top; ++word) {
    *word = kPaint;
  }
}

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

uint32_t stack_used() {
  return used_below(__stack_top);
}

__attribute__((noinline)) void paint_stack() {
  paint_below(stack_pointer());
}

__attribute__((noinline)) uint32_t stack_of_call(Call function, void* context) {
  uint32_t* const top = stack_pointer();
  paint_below(top);
  function(context);
  return used_below(top);
}

}  // namespace port
