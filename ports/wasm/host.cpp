// Implements the Arm semihosting calls of programs by WASI.
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "semihosting.hpp"

namespace port {

int32_t call_host(HostCall call, const void* argument) {
  switch (call) {
    case HostCall::write0: {
      const char* const text = static_cast<const char*>(argument);
      return write(STDOUT_FILENO, text, strlen(text)) < 0 ? -1 : 0;
    }
    case HostCall::exit_extended:
      _Exit(static_cast<int>(static_cast<const uintptr_t*>(argument)[1]));
    default:  // left to the C library
      return -1;
  }
}

}  // namespace port
