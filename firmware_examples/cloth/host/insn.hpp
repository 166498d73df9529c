// The board's insn.hpp, on the host, where nothing is counted.
#ifndef FLASHBVH_CLOTH_INSN_HPP
#define FLASHBVH_CLOTH_INSN_HPP

#include <stdint.h>

namespace port {

template <class Function>
uint32_t instructions_of(Function function) {
  function();
  return 0;
}

}  // namespace port

#endif
