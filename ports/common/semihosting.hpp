// Semihosting: calls by which a program without an operating system prints and ends through the
// emulator's (or debug probe's) host. Sources: Arm, "Semihosting for AArch32 and AArch64"; RISC-V
// International, "RISC-V Semihosting".
#pragma once

#include <stdint.h>

namespace port {

enum class HostCall : uint32_t {
  write0 = 0x04,         ///< writes a string that ends with 0
  exit = 0x18,           ///< takes a reason only
  exit_extended = 0x20,  ///< takes a reason and a status
};

/// Makes one call. `argument` depends on the call: mostly the address of a block of words.
#if defined(__wasm__)
int32_t call_host(HostCall call, const void* argument);  // host.cpp
#else
inline int32_t call_host(HostCall call, const void* argument) {
#if defined(__riscv)
  register uint32_t a0 __asm__("a0") = static_cast<uint32_t>(call);
  register const void* a1 __asm__("a1") = argument;
  // The host recognises a call by the two shifts around the breakpoint; all three are uncompressed
  // and in one page.
  __asm__ volatile(
      ".option push\n"
      ".option norvc\n"
      ".balign 16\n"
      "slli x0, x0, 0x1f\n"
      "ebreak\n"
      "srai x0, x0, 7\n"
      ".option pop\n"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return static_cast<int32_t>(a0);
#else
  register uint32_t r0 __asm__("r0") = static_cast<uint32_t>(call);
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<int32_t>(r0);
#endif
}
#endif

/// Statuses with which a program ends itself. 124 is free for timeout(1).
enum ExitStatus : int {
  kExitCounterNotExact = 121,
  kExitFault = 123,
  kExitUnexpectedInterrupt = 125,
};

/// Ends the program; the emulator exits with the low 8 bits of `status`.
[[noreturn]] inline void exit_program(int status) {
  constexpr uintptr_t kApplicationExit = 0x20026;
  constexpr uintptr_t kRunTimeError = 0x20023;
  const uintptr_t block[2] = {kApplicationExit, static_cast<uintptr_t>(status)};
  call_host(HostCall::exit_extended, block);
  // A host without the extended call distinguishes only success and failure.
  const uintptr_t reason = status == 0 ? kApplicationExit : kRunTimeError;
  call_host(HostCall::exit, reinterpret_cast<const void*>(reason));
  for (;;) {
  }
}

}  // namespace port
