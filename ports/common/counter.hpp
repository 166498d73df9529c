// What insn.cpp needs of an architecture: a count that is off by a constant, and code of known
// length to check it by.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Instructions of `function(context)` and of the code around every call, always as many.
uint32_t counted(Call function, void* context);

/// Returns at once.
void empty(void*);

/// Goes round `passes` times, at least once, and returns.
void known_loop(void* passes);
extern const uint32_t kInstructionsPerPass;

}  // namespace port
