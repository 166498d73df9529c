// A straight move of the printer's nozzle. A real planner parses G-code; this example's program is
// a table in flash, which program.py writes.
#pragma once

#include <stdint.h>

struct Place {
  int32_t axis[3];  ///< in micrometres
};

struct Block {
  Place from;
  Place to;
  int32_t speed;  ///< in micrometres per second

  /// In micrometres.
  float length() const {
    float squared = 0;
    for (int i = 0; i < 3; ++i) {
      const auto along = static_cast<float>(to.axis[i] - from.axis[i]);
      squared += along * along;
    }
    return __builtin_sqrtf(squared);
  }

  Place at(float part) const {
    Place place = from;
    for (int i = 0; i < 3; ++i) {
      place.axis[i] += static_cast<int32_t>(static_cast<float>(to.axis[i] - from.axis[i]) * part);
    }
    return place;
  }
};

const Block kProgram[] = {
#include "program.inc"
};
