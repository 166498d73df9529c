// Shared by the drivers of programs with published cycles.
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

/// Prints the cycles of `function()` by name alone.
template <class Function>
void print_cycles(const char* name, Function function) {
  port::print("cycles ", name, " ", port::cycles_of_call(port::call_object<Function>, &function),
              "\n");
}

/// The program's exit status; prints an error unless all answers were `right`.
inline int end(bool right) {
  port::put(right ? "" : "an answer is wrong\n");
  return right ? 0 : 1;
}
