// Start-up of every core between reset and main(), once the stack pointer is set.
#pragma once

#include <stdint.h>

// Addresses that sections.ld defines.
extern "C" {
extern uint32_t __data_load[], __data_start[], __data_end[];
extern uint32_t __bss_start[], __bss_end[];
extern uint32_t __stack_limit[], __stack_top[];
extern char __heap_start[], __heap_end[];
}

namespace port {

/// Fills .data and .bss, paints the stack, constructs the static objects, runs main() and ends the
/// program with its result.
[[noreturn]] void start_program();

}  // namespace port
