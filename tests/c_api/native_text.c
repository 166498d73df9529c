/* The boards' text output, on this machine. */
#include "text.h"

#include <stdio.h>

void port_put(const char* text) {
  fputs(text, stdout);
}

void port_put_number(long value) {
  printf("%ld", value);
}
