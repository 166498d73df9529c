// The boards' text output for C (ports/common/text.h), implemented for this machine.
#include <iostream>

#include "text.h"

void port_put(const char* text) {
  std::cout << text;
}

void port_put_number(long value) {
  std::cout << value;
}
