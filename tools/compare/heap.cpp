// The system calls of newlib that OPCODE and the C++ library link: a heap between .bss and the
// stack. All others fail.
#include <stddef.h>

#include "semihosting.hpp"
#include "start.hpp"
#include "text.hpp"

extern "C" {

// libstdc++ registers destructors with this variable's address.
void* __dso_handle = nullptr;

void* _sbrk(ptrdiff_t bytes) {
  static char* end = __heap_start;
  if (bytes > __heap_end - end) {
    port::put("[port] the heap is used up\n");
    port::exit_program(1);
  }
  char* const block = end;
  end += bytes;
  return block;
}

[[noreturn]] void _exit(int status) {
  port::exit_program(status);
}

#define COMPARE_FAILS(name) \
  int name() {              \
    return -1;              \
  }
COMPARE_FAILS(_close)
COMPARE_FAILS(_fstat)
COMPARE_FAILS(_getpid)
COMPARE_FAILS(_isatty)
COMPARE_FAILS(_kill)
COMPARE_FAILS(_lseek)
COMPARE_FAILS(_read)
COMPARE_FAILS(_write)
}
