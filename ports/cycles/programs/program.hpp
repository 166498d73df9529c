// What the drivers of programs with published cycles share.
#pragma once

#include <stdint.h>

#include "cycles.hpp"
#include "text.hpp"

/// Prints the cycles of `function()` by name and number, as tools/cycles.py reads them.
template <class Function>
void print_cycles(const char* name, int number, Function function) {
  port::print("cycles ", name, number, " ",
              port::cycles_of_call(port::call_object<Function>, &function), "\n");
}

/// The same by name alone.
template <class Function>
void print_cycles(const char* name, Function function) {
  port::print("cycles ", name, " ", port::cycles_of_call(port::call_object<Function>, &function),
              "\n");
}

/// The status of a program whose answers were all `right`.
inline int end(bool right) {
  port::put(right ? "" : "an answer is wrong\n");
  return right ? 0 : 1;
}
