// Cycles of code, counted by a QEMU plugin with a model of the core (lib/docs/cycles.md).
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Returns whether the plugin runs.
bool counts_cycles();

/// Cycles that `function(context)` takes; an empty function counts 0. The plugin has to run.
uint32_t cycles_of_call(Call function, void* context);

}  // namespace port
