// Prints each argument as <argument>; the first one, as a number, is the exit status.
#include "text.hpp"

namespace {

int to_int(const char* digits) {
  int value = 0;
  for (; *digits >= '0' && *digits <= '9'; ++digits) {
    value = value * 10 + (*digits - '0');
  }
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    port::print("<", argv[i], ">");
  }
  port::put("\n");
  return argc > 1 ? to_int(argv[1]) : 0;
}
