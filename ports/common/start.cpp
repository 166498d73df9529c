#include "start.hpp"

#include "semihosting.hpp"
#include "stack.hpp"

extern "C" {
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
}

// ISO C++ forbids calling main(), but start-up code has to call it.
#pragma GCC diagnostic ignored "-Wpedantic"
int main();

namespace port {
namespace {

void fill_data_and_bss() {
  const uint32_t* source = __data_load;
  for (uint32_t* target = __data_start; target < __data_end; ++target) {
    *target = *source++;
  }
  for (uint32_t* target = __bss_start; target < __bss_end; ++target) {
    *target = 0;
  }
}

void construct_static_objects() {
  for (auto constructor = __init_array_start; constructor < __init_array_end; ++constructor) {
    (*constructor)();
  }
}

}  // namespace

void start_program() {
  fill_data_and_bss();
  paint_stack();
  construct_static_objects();
  exit_program(main());
}

}  // namespace port
