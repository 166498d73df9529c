// A control task: a function that a timer interrupt calls at a fixed rate.
//
// Time is QEMU's under `-icount shift=8` (insn.hpp), where an instruction takes 256 ns. A rate is
// given as the instructions between two interrupts: 168,000 for 1 kHz on a core of 168 MHz that
// executes one instruction per cycle. On Cortex-M the interrupt is SysTick's, so a program links
// either this or insn.hpp. Other start-up code takes no interrupts; a loop replaces the timer.
#pragma once

#include <stdint.h>

#include "call.hpp"

namespace port {

/// Time that the task took of its periods.
struct TaskTime {
  uint32_t periods;
  uint32_t late;          ///< calls that took longer than a period
  uint32_t most;          ///< most instructions of a call that was not late, interrupt included
  uint64_t instructions;  ///< of all calls that were not late
};

/// Sets `*done` to end the calls.
using Task = void (*)(void* context, bool* done);

TaskTime run_task(uint32_t instructions_a_period, Task task, void* context);

/// Calls `function()` at the given rate until it returns false; the core sleeps in between. Up to
/// 390,000 instructions per period on a board with a clock of 168 MHz, more on slower boards.
template <class Function>
TaskTime each_period(uint32_t instructions_a_period, Function function) {
  return run_task(
      instructions_a_period,
      [](void* context, bool* done) { *done = !(*static_cast<Function*>(context))(); }, &function);
}

}  // namespace port
