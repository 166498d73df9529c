// Tests a peg 0.5 mm above a plate, then 2 mm deep in it; prints both answers over USB each second.
#include "../query.hpp"

#include <pico/stdlib.h>
#include <stdio.h>

int main() {
  stdio_init_all();
  for (;;) {
    printf("0.5 mm above the plate: %s\n", touches(cells(0.5)) ? "touches" : "free");
    printf("2 mm into the plate: %s\n", touches(cells(-2)) ? "touches" : "free");
    sleep_ms(1000);
  }
}
