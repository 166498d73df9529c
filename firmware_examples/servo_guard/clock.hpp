// Microseconds, modulo 2^32, by the core's timer, which wraps every 2^24 cycles: to be read more
// often.
#pragma once

#include "systick.hpp"

namespace servo {

template <uint32_t megahertz>
class Clock {
 public:
  Clock() {
    port::systick().reload = 0xFFFFFF;
    port::systick().current = 0;
    port::systick().control = 5;  // processor clock, enable
  }
  uint32_t microseconds() {
    const uint32_t count = port::systick().current;
    ticks_ += (last_ - count) & 0xFFFFFF;
    last_ = count;
    return static_cast<uint32_t>(ticks_ / megahertz);
  }

 private:
  uint64_t ticks_ = 0;
  uint32_t last_ = 0;
};

}  // namespace servo
