// Reset, the vector table and faults of every Cortex-M.
#include <stdint.h>

#include "semihosting.hpp"
#include "start.hpp"
#include "text.hpp"

// Armv8-M Mainline has a register that bounds the stack.
#if __ARM_ARCH >= 8 && __ARM_ARCH_ISA_THUMB >= 2
#define FLASHBVH_PORT_STACK_LIMIT 1
#else
#define FLASHBVH_PORT_STACK_LIMIT 0
#endif

extern "C" {
void Reset_Handler();
void Fault_Handler();
void Unexpected_Handler();

// A program replaces a handler by defining a function of the handler's name.
#define FLASHBVH_PORT_HANDLER __attribute__((weak, alias("Unexpected_Handler")))
void NMI_Handler() FLASHBVH_PORT_HANDLER;
void SVC_Handler() FLASHBVH_PORT_HANDLER;
void DebugMon_Handler() FLASHBVH_PORT_HANDLER;
void PendSV_Handler() FLASHBVH_PORT_HANDLER;
void SysTick_Handler() FLASHBVH_PORT_HANDLER;
}

namespace {

using Handler = void (*)();

struct VectorTable {
  uint32_t* initial_stack_pointer;
  Handler handlers[15];
};

// The system exceptions only: no firmware here enables an interrupt of a peripheral.
__attribute__((section(".vectors"), used)) const VectorTable vector_table = {
    __stack_top,
    {Reset_Handler, NMI_Handler, Fault_Handler, Fault_Handler, Fault_Handler, Fault_Handler,
     Fault_Handler, nullptr, nullptr, nullptr, SVC_Handler, DebugMon_Handler, nullptr,
     PendSV_Handler, SysTick_Handler}};

inline volatile uint32_t& system_register(uintptr_t address) {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

void enable_coprocessors() {
#if defined(__ARM_FP) || defined(__ARM_FEATURE_MVE)
  constexpr uintptr_t kCoprocessorAccessControl = 0xE000ED88;
  constexpr uint32_t kFullAccessToFpu = 0xF << 20;
  system_register(kCoprocessorAccessControl) |= kFullAccessToFpu;
  __asm__ volatile("dsb\n isb" ::: "memory");
#endif
}

// A core with the register faults if the stack outgrows its limit; other cores run on.
void guard_stack() {
#if FLASHBVH_PORT_STACK_LIMIT
  __asm__ volatile("msr msplim, %0" ::"r"(__stack_limit));
#endif
}

bool stack_overflowed() {
#if FLASHBVH_PORT_STACK_LIMIT
  constexpr uintptr_t kConfigurableFaultStatus = 0xE000ED28;
  constexpr uint32_t kStackOverflow = 1 << 20;
  return (system_register(kConfigurableFaultStatus) & kStackOverflow) != 0;
#else
  return false;
#endif
}

}  // namespace

extern "C" {

// Some loaders start a program without fetching its vectors, so the stack pointer is set here.
__attribute__((naked, used)) void Reset_Handler() {
  __asm__ volatile(
      "  ldr r0, =__stack_top\n"
      "  mov sp, r0\n"
      "  bl port_reset\n"
      "  .ltorg\n");
}

[[noreturn]] __attribute__((used)) void port_reset() {
  enable_coprocessors();
  guard_stack();
  port::start_program();
}

// A fault may leave an unusable stack, so the handler resets the stack pointer.
__attribute__((naked, used)) void Fault_Handler() {
  __asm__ volatile(
#if FLASHBVH_PORT_STACK_LIMIT
      "  movs r0, #0\n"
      "  msr msplim, r0\n"
#endif
      "  ldr r0, =__stack_top\n"
      "  mov sp, r0\n"
      "  bl port_fault\n"
      "  .ltorg\n");
}

[[noreturn]] __attribute__((used)) void port_fault() {
  port::put(stack_overflowed() ? "\n[port] fault: stack overflow\n" : "\n[port] fault\n");
  port::exit_program(port::kExitFault);
}

void Unexpected_Handler() {
  port::put("\n[port] unexpected interrupt\n");
  port::exit_program(port::kExitUnexpectedInterrupt);
}
}
