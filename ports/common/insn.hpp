// Exact instruction counts, from inside the program.
//
// Under `-icount shift=8` (FLASHBVH_ICOUNT=8 ports/run ...) each instruction takes 256 ns of
// virtual time, at least 2.5 ticks of the core's timer on every board. The rounded quotient is the
// number of instructions, not cycles: a division and a push of eight registers count 1 each.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Instructions that `function(context)` executes, up to 2^32 - 1; an empty function counts 0.
///
/// Ends the program with kExitCounterNotExact if the counter is wrong on a loop of known length, as
/// without `-icount`. `function` must not mask interrupts for long (2 million instructions) and
/// must not count instructions itself.
uint32_t instructions_of_call(Call function, void* context);

/// Instructions that `function()` executes, the loads of its captures included.
template <class Function>
uint32_t instructions_of(Function function) {
  return instructions_of_call(call_object<Function>, &function);
}

}  // namespace port
