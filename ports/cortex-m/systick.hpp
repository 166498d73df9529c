// The core's timer.
#pragma once

#include <stdint.h>

namespace port {

struct SysTick {
  uint32_t control;
  uint32_t reload;
  uint32_t current;  ///< counts down; any write clears it
};

inline volatile SysTick& systick() {
  return *reinterpret_cast<volatile SysTick*>(0xE000E010);
}

constexpr uint32_t kStop = 4;   ///< processor clock; QEMU loses the count when the clock changes
constexpr uint32_t kCount = 7;  ///< processor clock, interrupt at the wrap, enable
constexpr uint32_t kHasWrapped = 1U << 16;  ///< bit of `control`, cleared when it is read

/// Clears a pending interrupt, which is due already if the last one took longer than a period.
inline void forget_tick() {
  constexpr uint32_t kClearPending = 1U << 25;
  *reinterpret_cast<volatile uint32_t*>(0xE000ED04) = kClearPending;
  __asm__ volatile("dsb" ::: "memory");
}

}  // namespace port
