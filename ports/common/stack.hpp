// How deep the stack got. The unused stack is painted with a word; what a program has written since
// no longer carries it. Resolution 4 bytes; what a frame reserves below its last written word is
// not seen, so compare with -fstack-usage.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Bytes that the linker script reserves for the stack.
uint32_t stack_size();

/// Bytes of RAM of .data and .bss. Not in WebAssembly.
uint32_t static_bytes();

/// Bytes of stack that the program has used at most since its start, or, once stack_of() has
/// painted again, since then.
uint32_t stack_used();

/// Bytes of stack that `function(context)` uses, with all that it calls. An empty function uses 0.
uint32_t stack_of_call(Call function, void* context);

/// Bytes of stack that `function()` uses, its own frame included.
template <class Function>
uint32_t stack_of(Function function) {
  return stack_of_call(call_object<Function>, &function);
}

/// Paints the stack below the caller's frame. The start-up code has done it once.
void paint_stack();

}  // namespace port
