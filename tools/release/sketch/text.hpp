// What the examples print, on the serial monitor.
#ifndef FLASHBVH_SKETCH_TEXT_HPP
#define FLASHBVH_SKETCH_TEXT_HPP

#include <Arduino.h>

namespace port {

template <class... Values>
void print(Values... values) {
  (Serial.print(values), ...);
}

}  // namespace port

#endif
