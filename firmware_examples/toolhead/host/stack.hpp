// The board's stack.hpp, on the host, where nothing is measured.
#pragma once

#include <stdint.h>

namespace port {

inline uint32_t static_bytes() {
  return 0;
}
inline uint32_t stack_used() {
  return 0;
}

}  // namespace port
