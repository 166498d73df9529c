// Arithmetic of counts.
#pragma once

#include <stdint.h>

namespace servo {

inline int32_t least(int32_t a, int32_t b) {
  return a < b ? a : b;
}
inline int32_t most(int32_t a, int32_t b) {
  return a < b ? b : a;
}
inline int32_t clipped(int32_t value, int32_t low, int32_t high) {
  return most(low, least(value, high));
}
inline int32_t apart(int32_t a, int32_t b) {
  return a < b ? b - a : a - b;
}

}  // namespace servo
