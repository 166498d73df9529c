// Tests the cycles of every kind of instruction against the cores' manuals (ports/cycles/tables),
// for the core CYCLES_OF, whose code the board's core can run.
#include "cycles.hpp"

#include <stdint.h>

#include "checks.hpp"

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

}  // namespace

int main() {
  words[0] = reinterpret_cast<uintptr_t>(words);
  for (const Case& tested : kCases) {
    if (tested.cycles != kNone) {
      expect(tested.name, port::cycles_of_call(tested.code, words), tested.cycles);
    }
  }
  return end_checks();
}
