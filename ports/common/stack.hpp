// Measures the stack's depth: the unused stack is painted with a word, which a program overwrites.
// The resolution is 4 bytes. A frame's bytes below its last written word are not detected; compare
// with -fstack-usage.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Bytes that the linker script reserves for the stack.
uint32_t stack_size();

/// Bytes of RAM of .data and .bss. Not in WebAssembly.
uint32_t static_bytes();

/// High-water mark of the stack in bytes, since the program's start or since stack_of() painted
/// again.
uint32_t stack_used();

/// Bytes of stack that `function(context)` and its callees use. An empty function uses 0.
uint32_t stack_of_call(Call function, void* context);

/// Bytes of stack that `function()` uses, its own frame included.
template <class Function>
uint32_t stack_of(Function function) {
  return stack_of_call(call_object<Function>, &function);
}

/// Paints the stack below the caller's frame. The start-up code calls it once.
void paint_stack();

}  // namespace port
