// One number for the answers of many queries.
#pragma once

#include <stdint.h>

namespace digest {

/// FNV-1a over 32-bit words, 64 bits.
class Hash {
 public:
  void add(uint32_t word) {
    for (int i = 0; i < 4; ++i) {
      value_ = (value_ ^ (word & 0xFFu)) * 0x100000001B3u;
      word >>= 8;
    }
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xCBF29CE484222325u;
};

}  // namespace digest
