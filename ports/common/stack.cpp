#include "stack.hpp"

#include "paint.hpp"
#include "start.hpp"

namespace port {
namespace {

// Inlined, as painting is: a frame of its own would lie in the painted area.
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
  paint_below_frame();
}

__attribute__((noinline)) uint32_t stack_of_call(Call function, void* context) {
  uint32_t* const top = paint_below_frame();
  function(context);
  return used_below(top);
}

}  // namespace port
