// Goes wrong in the way that the first argument names.
#include <stdint.h>
#include <string.h>

#include "text.hpp"

namespace {

void pend(uint32_t interrupt_control_bit) {
  *reinterpret_cast<volatile uint32_t*>(0xE000ED04) = interrupt_control_bit;
  __asm__ volatile("dsb\n isb" ::: "memory");
}

constexpr uint32_t kPendSystick = 1U << 26;
constexpr uint32_t kPendSupervisor = 1U << 28;

void undefined_instruction() {
  __asm__ volatile("udf #0");
}

void leave_stack() {
  __asm__ volatile(
      "movs r0, #0\n"
      "mov sp, r0\n"
      "udf #0\n");
}

// An even address asks for the Arm instruction set, which the core does not have.
void branch_into_data() {
  static volatile uint32_t data[2];
  __asm__ volatile("bx %0" ::"r"(data));
}

void hang() {
  for (;;) {
    __asm__ volatile("");
  }
}

struct Way {
  const char* name;
  void (*go)();
};

const Way kWays[] = {
    {"undefined instruction", undefined_instruction},
    {"stack pointer outside memory", leave_stack},
    {"branch into data", branch_into_data},
    {"fault in an interrupt", [] { pend(kPendSystick); }},
    {"unexpected interrupt", [] { pend(kPendSupervisor); }},
    {"hang", hang},
};

}  // namespace

extern "C" void SysTick_Handler() {
  undefined_instruction();
}

int main(int argc, char** argv) {
  for (const Way& way : kWays) {
    if (argc == 2 && strcmp(argv[1], way.name) == 0) {
      way.go();
    }
  }
  port::put("nothing went wrong\n");
  return 1;
}
