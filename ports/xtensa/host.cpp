// Implements the port's Arm semihosting calls by Xtensa's own semihosting, `simcall`.
#include <stddef.h>
#include <string.h>

#include "semihosting.hpp"

namespace port {
namespace {

enum : uint32_t {
  kExit = 1,
  kWrite = 4,
  kArgumentCount = 1000,
  kArgumentsSize = 1001,
  kArguments = 1002
};

int32_t simcall(uint32_t call, uint32_t first, uint32_t second = 0, uint32_t third = 0) {
  register uint32_t a2 __asm__("a2") = call;
  register uint32_t a3 __asm__("a3") = first;
  register uint32_t a4 __asm__("a4") = second;
  register uint32_t a5 __asm__("a5") = third;
  __asm__ volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
  return static_cast<int32_t>(a2);
}

uint32_t write(const void* text, uint32_t length) {
  constexpr uint32_t kStandardOutput = 1;
  const int32_t written = simcall(kWrite, kStandardOutput,
                                  static_cast<uint32_t>(reinterpret_cast<uintptr_t>(text)), length);
  return written < 0 ? 0 : static_cast<uint32_t>(written);
}

/// Joins the host's words into one line. The host stores them after their addresses and a null.
int32_t get_command_line(char* line, uint32_t size) {
  const int32_t count = simcall(kArgumentCount, 0);
  if (simcall(kArgumentsSize, 0) > static_cast<int32_t>(size)) {
    return -1;
  }
  simcall(kArguments, static_cast<uint32_t>(reinterpret_cast<uintptr_t>(line)));
  const char* word = line + (static_cast<uint32_t>(count) + 1) * sizeof(char*);
  char* end = line;
  for (int32_t i = 0; i < count; ++i) {
    const size_t length = strlen(word);
    memmove(end, word, length);
    end += length;
    *end++ = ' ';
    word += length + 1;
  }
  *end = '\0';
  return 0;
}

}  // namespace

int32_t call_host(HostCall call, const void* argument) {
  const uint32_t* const block = static_cast<const uint32_t*>(argument);
  switch (call) {
    case HostCall::open:  // only the terminal exists
      return strcmp(reinterpret_cast<const char*>(block[0]), ":tt") == 0 ? 1 : -1;
    case HostCall::write0:
      write(argument, static_cast<uint32_t>(strlen(static_cast<const char*>(argument))));
      return 0;
    case HostCall::write:
      return static_cast<int32_t>(block[2] -
                                  write(reinterpret_cast<const void*>(block[1]), block[2]));
    case HostCall::get_command_line:
      return get_command_line(reinterpret_cast<char*>(block[0]), block[1]);
    case HostCall::exit_extended:
      return simcall(kExit, block[1]);
    case HostCall::close:
    case HostCall::read:
    case HostCall::clock:
    case HostCall::exit:
      break;
  }
  return 0;
}

}  // namespace port
