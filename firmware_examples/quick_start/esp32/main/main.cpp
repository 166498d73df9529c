// On the console: a peg 0.5 mm above a plate, and 2 mm in it.
#include "../../query.hpp"

#include <stdio.h>

extern "C" void app_main() {
  printf("0.5 mm above the plate: %s\n", touches(cells(0.5)) ? "touches" : "free");
  printf("2 mm into the plate: %s\n", touches(cells(-2)) ? "touches" : "free");
}
