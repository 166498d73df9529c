// Tests the cycles of every kind of instruction against the cores' manuals (ports/cycles/tables),
// for the core CYCLES_OF, whose code the board's core can run.
#include "cycles.hpp"

#include <stdint.h>

#include "text.hpp"

namespace {

#define CASE(name, code, m0, m0plus, m3, m4f)                \
  __attribute__((naked, aligned(4))) void name(void*) {      \
    __asm__ volatile(".syntax unified\n" code "\n bx lr\n"); \
  }
#include "cycles_cases.inc"
#undef CASE

struct Cycles {
  uint32_t m0;
  uint32_t m0plus;
  uint32_t m3;
  uint32_t m4f;
};

constexpr uint32_t kNone = UINT32_MAX;

struct Case {
  const char* name;
  port::Call code;
  uint32_t cycles;
};

constexpr Case kCases[] = {
#define CASE(name, code, m0, m0plus, m3, m4f) {#name, name, Cycles{m0, m0plus, m3, m4f}.CYCLES_OF},
#include "cycles_cases.inc"
#undef CASE
};

uint32_t words[8];

/// Returns whether a case takes the expected cycles.
bool is_right(const Case& tested) {
  words[0] = reinterpret_cast<uintptr_t>(words);
  const uint32_t cycles = port::cycles_of_call(tested.code, words);
  if (cycles != tested.cycles) {
    port::print(tested.name, ": ", cycles, " cycles, expected ", tested.cycles, "\n");
  }
  return cycles == tested.cycles;
}

}  // namespace

int main() {
  int wrong = 0;
  int cases = 0;
  for (const Case& tested : kCases) {
    if (tested.cycles != kNone) {
      ++cases;
      wrong += is_right(tested) ? 0 : 1;
    }
  }
  port::print("wrong cycles: ", wrong, " of ", cases, "\n");
  return wrong == 0 ? 0 : 1;
}
