// A control task: a function that a timer's interrupt calls at a fixed rate.
//
// Time is QEMU's under `-icount shift=8` (insn.hpp), where an instruction takes 256 ns: a rate is
// given as the instructions between two interrupts, 168,000 for 1 kHz on a core of 168 MHz that
// executes one a cycle. On Cortex-M the interrupt is SysTick's, so a program has this or insn.hpp.
// Elsewhere, where start-up code takes no interrupts, a loop stands for the timer.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// What the task took of its periods.
struct TaskTime {
  uint32_t periods;
  uint32_t late;          ///< calls that took longer than a period
  uint32_t most;          ///< instructions of a call, with the interrupt's own; late ones left out
  uint64_t instructions;  ///< of all calls but late ones
};

/// Sets `*done` when it does not want to be called again.
using Task = void (*)(void* context, bool* done);

TaskTime run_task(uint32_t instructions_a_period, Task task, void* context);

/// Calls `function()` at that rate until it returns false; the core sleeps in between. Up to
/// 390,000 instructions a period on a board whose clock is 168 MHz, more on slower ones.
template <class Function>
TaskTime each_period(uint32_t instructions_a_period, Function function) {
  return run_task(
      instructions_a_period,
      [](void* context, bool* done) { *done = !(*static_cast<Function*>(context))(); }, &function);
}

}  // namespace port
