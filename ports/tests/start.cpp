// Tests all tasks of start-up code between reset and main().
#include <stdint.h>

#include "checks.hpp"
#include "stack.hpp"

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
  expect(".data, filled from flash", in_data[0], 1);
  expect("the end of .data", in_data[3], 0x12345678);
  expect(".bss is zero", bss_is_zero() ? 1 : 0, 1);
  expect("a static object, constructed after .data is filled", constructed.value, 42);
  const float product = 1.0F / third * 3.0F;
  expect("float", product > 0.999F && product < 1.001F ? 1 : 0, 1);
  expect("double", static_cast<uint32_t>(static_cast<int>(1e6 / tenth)), 100000);
  port::print("a stack of ", port::stack_size(), " bytes\n");  // also uses some stack
  expect("the stack is painted", port::stack_used(), 1, 511);
  expect("the stack's size", port::stack_size(), 1024, UINT32_MAX);
  return end_checks();
}
