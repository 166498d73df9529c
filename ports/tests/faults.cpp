// Causes the fault that the first argument names.
#include <stdint.h>
#include <string.h>

#include "text.hpp"
#include "ways.hpp"

namespace {

void branch_into_data() {
  static volatile uint32_t data[2];
  branch_to(data);
}

void hang() {
  for (;;) {
    __asm__ volatile("");
  }
}

struct Way {
  const char* name;
  void (*go)();
};

const Way kWays[] = {
    {"undefined instruction", undefined_instruction}, {"stack pointer outside memory", leave_stack},
    {"branch into data", branch_into_data},           {"fault in an interrupt", raise_handled},
    {"unexpected interrupt", raise_unhandled},        {"hang", hang},
};

}  // namespace

int main(int argc, char** argv) {
  for (const Way& way : kWays) {
    if (argc == 2 && strcmp(argv[1], way.name) == 0) {
      way.go();
    }
  }
  port::put("nothing went wrong\n");
  return 1;
}
