// Tests all tasks of start-up code between reset and main().
#include <stdint.h>

#include "stack.hpp"
#include "text.hpp"

namespace {

struct Constructed {
  explicit Constructed(uint32_t seed) : value(seed * 3) {}
  uint32_t value;
};

volatile uint32_t seed = 14;
volatile uint32_t in_data[4] = {1, 2, 3, 0x12345678};
volatile uint32_t in_bss[64];
Constructed constructed(seed);
volatile float third = 3.0F;
volatile double tenth = 10.0;

int failures = 0;

void check(bool holds, const char* what) {
  if (!holds) {
    ++failures;
    port::print("failed: ", what, "\n");
  }
}

bool bss_is_zero() {
  for (const volatile uint32_t& word : in_bss) {
    if (word != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

int main() {
  check(in_data[0] == 1 && in_data[3] == 0x12345678, ".data is filled from flash");
  check(bss_is_zero(), ".bss is zero");
  check(constructed.value == 42, "a static object is constructed, after .data is filled");
  const float product = 1.0F / third * 3.0F;
  check(product > 0.999F && product < 1.001F, "float");
  check(static_cast<int>(1e6 / tenth) == 100000, "double");
  port::print("a stack of ", port::stack_size(), " bytes\n");  // also uses some stack
  check(port::stack_used() > 0 && port::stack_used() < 512, "the stack is painted");
  check(port::stack_size() >= 1024, "the stack has a size");
  if (failures == 0) {
    port::put("start-up as it should be\n");
  }
  return failures;
}
