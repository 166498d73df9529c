// Prints the examples' output on the serial monitor.
#pragma once

#include <Arduino.h>

namespace port {

template <class... Values>
void print(Values... values) {
  (Serial.print(values), ...);
}

}  // namespace port
