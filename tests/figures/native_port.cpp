// The board's text output on this machine, which counts no instructions.
#include <cstdio>

#include "insn.hpp"
#include "text.hpp"

namespace port {

uint32_t instructions_of_call(Call function, void* context) {
  function(context);
  return 0;
}

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
