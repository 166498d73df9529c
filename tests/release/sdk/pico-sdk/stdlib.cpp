#include <pico/stdlib.h>
#include <stdlib.h>

static bool has_output;

bool stdio_init_all() {
  return has_output = STDIO_USB != 0;
}

// Ends the program: a second time, it would print what it has printed.
void sleep_ms(uint32_t) {
  exit(has_output ? 0 : 1);
}
