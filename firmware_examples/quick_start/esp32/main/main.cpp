// Tests a peg 0.5 mm above a plate, then 2 mm deep in it; prints both answers on the console.
#include "../../query.hpp"

#include <stdio.h>

extern "C" void app_main() {
  printf("0.5 mm above the plate: %s\n", touches(cells(0.5)) ? "touches" : "free");
  printf("2 mm into the plate: %s\n", touches(cells(-2)) ? "touches" : "free");
}
