// Reset and exceptions of an Xtensa LX106, which has no register windows.
#include <stdint.h>

#include "semihosting.hpp"
#include "start.hpp"
#include "text.hpp"

extern "C" {
void Reset_Handler();
void Unexpected_Handler();
// A program replaces it by defining a function of this name. It must not return: the stack is new.
void Interrupt_Handler(uint32_t pending);

// The reset vector and the exception vectors at fixed offsets. A fault may leave an unusable stack,
// so the handler resets the stack pointer.
__asm__(
    ".pushsection .vectors, \"ax\"\n"
    ".global Reset_Handler\n"
    ".align 64\n"
    "Reset_Handler:\n"
    "  j start\n"
    ".org Reset_Handler + 0x10\n"  // debug
    "  j fault\n"
    ".org Reset_Handler + 0x20\n"  // not maskable
    "  j fault\n"
    ".org Reset_Handler + 0x30\n"  // in kernel mode
    "  j fault\n"
    ".org Reset_Handler + 0x50\n"  // in user mode
    "  j fault\n"
    ".org Reset_Handler + 0x70\n"  // within an exception
    "  j fault\n"
    ".align 4\n"
    ".literal_position\n"
    "start:\n"
    "  movi a2, Reset_Handler\n"
    "  wsr a2, vecbase\n"
    "  movi a2, 0\n"  // clears exception mode and interrupt level
    "  wsr a2, intenable\n"
    "  wsr a2, ps\n"
    "  rsync\n"
    "  movi sp, __stack_top\n"
    "  movi a2, port_reset\n"
    "  jx a2\n"
    ".align 4\n"
    ".literal_position\n"
    "fault:\n"
    "  movi sp, __stack_top\n"
    "  rsr a2, exccause\n"
    "  rsr a3, interrupt\n"
    "  rsr a4, intenable\n"
    "  and a3, a3, a4\n"
    "  movi a4, 0\n"
    "  wsr a4, intenable\n"  // else the interrupt is taken again
    "  wsr a4, ps\n"
    "  rsync\n"
    "  movi a4, port_fault\n"
    "  jx a4\n"
    ".popsection\n");

[[noreturn]] __attribute__((used)) void port_reset() {
  port::start_program();
}

[[noreturn]] __attribute__((used)) void port_fault(uint32_t cause, uint32_t pending) {
  constexpr uint32_t kInterrupt = 4;
  if (cause == kInterrupt) {
    Interrupt_Handler(pending);
  }
  port::put("\n[port] fault\n");
  port::exit_program(port::kExitFault);
}

void Unexpected_Handler() {
  port::put("\n[port] unexpected interrupt\n");
  port::exit_program(port::kExitUnexpectedInterrupt);
}

__attribute__((weak)) void Interrupt_Handler(uint32_t) {
  Unexpected_Handler();
}
}
