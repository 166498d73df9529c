// Shared by both modules.
#pragma once

#include <stdint.h>

#define EXPORT extern "C" __attribute__((visibility("default"), used))

namespace batches {

/// The length of a cell from its bits.
inline double length_of(uint64_t bits) {
  double length = 0;
  __builtin_memcpy(&length, &bits, sizeof length);
  return length;
}

}  // namespace batches
