// Text output for firmware that links no stdio: strings and decimal integers.
#pragma once

namespace port {

/// Writes its argument to the host's standard output, without a newline. At most 48 bytes of stack;
/// only the long long forms need libgcc's 64-bit division.
void put(const char* text);
void put(int value);
void put(unsigned value);
void put(long value);
void put(unsigned long value);
void put(long long value);
void put(unsigned long long value);

/// Writes its arguments one after the other: `print("visits ", visits, "\n")`.
template <class... Values>
void print(Values... values) {
  (put(values), ...);
}

}  // namespace port
