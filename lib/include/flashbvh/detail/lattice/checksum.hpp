// A checksum of words.
#ifndef FLASHBVH_DETAIL_LATTICE_CHECKSUM_HPP
#define FLASHBVH_DETAIL_LATTICE_CHECKSUM_HPP

#include <stdint.h>

namespace flashbvh::detail {

constexpr uint32_t kNoWords = 2166136261u;

/// Adds a word to a checksum. A rotation, an exclusive or and a product with an odd number are each
/// invertible. So different checksums stay different, and different words make them different: a
/// change of one word is always found. The rotation moves the top bits, which products leave in
/// place.
constexpr uint32_t with_word(uint32_t checksum, uint32_t word) {
  return ((checksum << 7 | checksum >> 25) ^ word) * 0x9E3779B1u;
}

}  // namespace flashbvh::detail

#endif
