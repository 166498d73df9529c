#include "insn.hpp"

#include "counter.hpp"
#include "semihosting.hpp"
#include "text.hpp"

namespace port {

uint32_t instructions_of_call(Call function, void* context) {
  constexpr uint32_t kPasses = 100;
  const uint32_t overhead = counted(empty, nullptr);
  const uint32_t loop = counted(known_loop, reinterpret_cast<void*>(uintptr_t{kPasses})) - overhead;
  if (loop != kPasses * kInstructionsPerPass) {
    put("[port] the instruction counter is not exact: run QEMU with -icount shift=");
    put(FLASHBVH_ICOUNT_SHIFT);
    put("\n");
    exit_program(kExitCounterNotExact);
  }
  return counted(function, context) - overhead;
}

}  // namespace port
