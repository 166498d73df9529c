// A single pass of the loop is enough for a test.
#include <Arduino.h>

#include "port_text.hpp"

Monitor Serial;

void Monitor::print(const char* text) {
  port::put(text);
}
void Monitor::print(int value) {
  port::put(value);
}
void Monitor::print(unsigned value) {
  port::put(value);
}
void Monitor::print(long value) {
  port::put(value);
}
void Monitor::print(unsigned long value) {
  port::put(value);
}

int main() {
  setup();
  loop();
  return 0;
}
