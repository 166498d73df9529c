#include <pico/stdlib.h>
#include <stdlib.h>

static bool has_output;

bool stdio_init_all() {
  return has_output = STDIO_USB != 0;
}

// Ends the program, which would otherwise print its output again.
void sleep_ms(uint32_t) {
  exit(has_output ? 0 : 1);
}
