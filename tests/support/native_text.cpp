// The boards' text output (ports/common/text.hpp and text.h), implemented for this machine.
#include <iostream>

#include "text.h"
#include "text.hpp"

#define FLASHBVH_PUT(Type)     \
  void port::put(Type value) { \
    std::cout << value;        \
  }
FLASHBVH_PUT(const char*)
FLASHBVH_PUT(int)
FLASHBVH_PUT(unsigned)
FLASHBVH_PUT(long)
FLASHBVH_PUT(unsigned long)
FLASHBVH_PUT(long long)
FLASHBVH_PUT(unsigned long long)

void port_put(const char* text) {
  port::put(text);
}

void port_put_number(long value) {
  port::put(value);
}
