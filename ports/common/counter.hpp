// An architecture's part of insn.cpp: a count with a constant error, and code of known length to
// check it.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Instructions of `function(context)` plus a constant, the code around every call.
uint32_t counted(Call function, void* context);

/// Returns at once.
void empty(void*);

/// Runs a loop of `passes` iterations, at least one.
void known_loop(void* passes);
extern const uint32_t kInstructionsPerPass;

}  // namespace port
