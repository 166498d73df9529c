// Checks of the port's tests: prints those that fail, and how many.
#pragma once

#include <stdint.h>

#include "text.hpp"

inline int checks = 0;
inline int failures = 0;

inline void expect(const char* what, uint32_t measured, uint32_t least, uint32_t most) {
  ++checks;
  if (measured < least || measured > most) {
    ++failures;
    port::print(what, ": ", measured, ", expected ", least, " to ", most, "\n");
  }
}

inline void expect(const char* what, uint32_t measured, uint32_t expected) {
  expect(what, measured, expected, expected);
}

/// Returns the program's exit status.
inline int end_checks() {
  port::print("failed: ", failures, " of ", checks, "\n");
  return failures == 0 ? 0 : 1;
}
