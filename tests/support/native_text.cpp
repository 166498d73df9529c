// The boards' text output (ports/common/text.hpp and text.h) on this machine.
#include <cstdio>

#include "text.h"
#include "text.hpp"

namespace port {

void put(const char* text) {
  std::fputs(text, stdout);
}

void put(int value) {
  std::printf("%d", value);
}

void put(unsigned value) {
  std::printf("%u", value);
}

void put(long value) {
  std::printf("%ld", value);
}

void put(unsigned long value) {
  std::printf("%lu", value);
}

void put(long long value) {
  std::printf("%lld", value);
}

void put(unsigned long long value) {
  std::printf("%llu", value);
}

}  // namespace port

void port_put(const char* text) {
  port::put(text);
}

void port_put_number(long value) {
  port::put(value);
}
