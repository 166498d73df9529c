// Tests the instruction counter on code of known length.
#include "insn.hpp"

#include "checks.hpp"
#include "counter.hpp"

namespace {

void expect_loop(uint32_t passes) {
  expect("a loop", port::instructions_of_call(port::known_loop, reinterpret_cast<void*>(passes)),
         port::kInstructionsPerPass * passes);
}

void expect_random_loops(int count) {
  uint32_t random = 1;
  for (int i = 0; i < count; ++i) {
    random = random * 1664525 + 1013904223;
    expect_loop(1 + (random >> 16) % 40000);
  }
}

// Tests counts around multiples of 2^24 ticks, where the timer of most boards wraps.
void expect_long_loops() {
  expect_loop(873813);
  expect_loop(873814);
  expect_loop(1000000);
  expect_loop(20000000);
}

}  // namespace

int main() {
  expect("nothing", port::instructions_of([] {}), 0);
  expect("three", port::instructions_of([] { __asm__ volatile("nop\n nop\n nop"); }), 3);
  expect_random_loops(100);
  expect_long_loops();
  return end_checks();
}
