// The cycles of every kind of instruction, by the rules of the cores' manuals
// (ports/cycles/tables).
#include "cycles.hpp"

#include <stdint.h>

#include "text.hpp"

namespace {

#define CASE(name, code, m0, m0plus, m3, m4)                 \
  __attribute__((naked, aligned(4))) void name(void*) {      \
    __asm__ volatile(".syntax unified\n" code "\n bx lr\n"); \
  }
#include "cycles_cases.inc"
#undef CASE

struct Case {
  const char* name;
  port::Call code;
  uint32_t cycles;
};

#if defined(MODEL_OF_M0PLUS)
#define OF_CORE(m0, m0plus, m3, m4) m0plus
#elif __ARM_ARCH == 6
#define OF_CORE(m0, m0plus, m3, m4) m0
#elif !defined(__ARM_FEATURE_DSP)
#define OF_CORE(m0, m0plus, m3, m4) m3
#else
#define OF_CORE(m0, m0plus, m3, m4) m4
#endif

constexpr Case kCases[] = {
#define CASE(name, code, m0, m0plus, m3, m4) {#name, name, OF_CORE(m0, m0plus, m3, m4)},
#include "cycles_cases.inc"
#undef CASE
};

uint32_t words[8];

}  // namespace

int main() {
  int wrong = 0;
  for (const Case& tested : kCases) {
    words[0] = reinterpret_cast<uintptr_t>(words);
    const uint32_t cycles = port::cycles_of_call(tested.code, words);
    if (cycles != tested.cycles) {
      ++wrong;
      port::print(tested.name, ": ", cycles, " cycles, expected ", tested.cycles, "\n");
    }
  }
  port::print("wrong cycles: ", wrong, " of ", sizeof kCases / sizeof *kCases, "\n");
  return wrong == 0 ? 0 : 1;
}
