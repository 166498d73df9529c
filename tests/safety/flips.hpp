// Bits of memory, flipped one at a time.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace flashbvh::test {

/// Calls flipped() with each bit of the memory flipped in turn, and flips it back. Returns the
/// number of calls that returned true.
template <class Flipped>
uint32_t count_flips(void* memory, size_t size, const Flipped& flipped) {
  auto* const bytes = static_cast<unsigned char*>(memory);
  uint32_t count = 0;
  for (size_t bit = 0; bit < 8 * size; ++bit) {
    const auto mask = static_cast<unsigned char>(1u << bit % 8);
    bytes[bit / 8] ^= mask;
    count += flipped() ? 1 : 0;
    bytes[bit / 8] ^= mask;
  }
  return count;
}

}  // namespace flashbvh::test
