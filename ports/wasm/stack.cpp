// stack.hpp for WebAssembly, where most of a frame is not in memory: counts only arrays and other
// variables that have an address. An overflow traps, since nothing lies below the stack.
#include "stack.hpp"

extern "C" char __global_base;  // top of the stack, set by wasm-ld

namespace port {
namespace {

constexpr uint32_t kPaint = 0xA5A5A5A5;

// Volatile, since address 0 is a word of the stack.
volatile uint32_t* const kLimit = nullptr;

volatile uint32_t* stack_pointer() {
  volatile uint32_t* top;
  __asm__ volatile(
      ".globaltype __stack_pointer, i32\n"
      "global.get __stack_pointer\n"
      "local.set %0\n"
      : "=r"(top));
  return top;
}

uint32_t used_below(const volatile uint32_t* top) {
  const volatile uint32_t* word = kLimit;
  while (word < top && *word == kPaint) {
    ++word;
  }
  return static_cast<uint32_t>(top - word) * sizeof(uint32_t);
}

}  // namespace

uint32_t stack_size() {
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&__global_base));
}

uint32_t stack_used() {
  return used_below(reinterpret_cast<volatile uint32_t*>(&__global_base));
}

__attribute__((constructor(101))) void paint_stack() {
  for (volatile uint32_t* word = kLimit; word < stack_pointer(); ++word) {
    *word = kPaint;
  }
}

uint32_t stack_of_call(Call function, void* context) {
  paint_stack();
  function(context);
  return used_below(stack_pointer());
}

}  // namespace port
