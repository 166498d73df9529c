// Tests a peg above a plate, on the plate, and wholly inside it; counts the cycles of one test.
#include "cycles.hpp"
#include "query.hpp"
#include "text.hpp"

int main() {
  const bool above = touches(cells(0.5));
  const uint32_t begin = core_cycles();
  const bool on = touches(cells(0));
  const uint32_t cycles = core_cycles() - begin;
  const bool in = touches(cells(-2));
  const bool inside = touches(cells(-35));  // 5 mm of the plate above and below it
  port::print("0.5 mm above the plate: ", above ? "touches" : "free", "\n");
  port::print("on the plate: ", on ? "touches" : "free", "\n");
  port::print("2 mm into the plate: ", in ? "touches" : "free", "\n");
  port::print("wholly inside the plate: ", inside ? "touches" : "free", "\n");
  if (cycles != 0) {
    port::print("on the plate: ", cycles, " cycles\n");
  }
  return !above && on && in && inside ? 0 : 1;
}
