// Causes the fault that FAULT names, or ends with the status EXIT.
#include <stdint.h>

#include "text.hpp"
#include "ways.hpp"

namespace {

[[maybe_unused]] void branch_into_data() {
  static volatile uint32_t data[2];
  branch_to(data);
}

[[maybe_unused]] void hang() {
  for (;;) {
    __asm__ volatile("");
  }
}

}  // namespace

int main() {
#if defined(EXIT)
  return EXIT;
#else
  FAULT();
  port::put("nothing went wrong\n");
  return 1;
#endif
}
