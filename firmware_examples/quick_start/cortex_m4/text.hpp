// Prints text by semihosting (startup.c), which QEMU and debug probes read. Use a UART instead.
#pragma once

#include <stdint.h>

extern "C" void write_text(const char* text);

namespace port {

inline void put(const char* text) {
  write_text(text);
}

inline void put(uint32_t number) {
  char text[11] = {};
  char* first = text + 10;
  do {
    *--first = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  write_text(first);
}

/// Prints texts and numbers.
template <class... Parts>
void print(Parts... parts) {
  (put(parts), ...);
}

}  // namespace port
