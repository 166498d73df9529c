// newlib's system calls, for tests: a heap between .bss and the stack, standard output, a clock.
// Firmware never links this file.
#include <errno.h>
#include <stddef.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/times.h>

#include "semihosting.hpp"
#include "start.hpp"
#include "text.hpp"

namespace {

char* heap_end = __heap_start;

uintptr_t standard_output() {
  static const char kTerminal[] = ":tt";
  constexpr uintptr_t kModeWrite = 4;
  static const uintptr_t block[3] = {reinterpret_cast<uintptr_t>(kTerminal), kModeWrite,
                                     sizeof kTerminal - 1};
  static const int32_t handle = port::call_host(port::HostCall::open, block);
  return static_cast<uintptr_t>(handle);
}

int fail(int error) {
  errno = error;
  return -1;
}

}  // namespace

extern "C" {

// libstdc++ registers destructors with this variable's address.
void* __dso_handle = nullptr;

void* _sbrk(ptrdiff_t bytes) {
  char* const block = heap_end;
  if (bytes > __heap_end - heap_end) {
    port::put("[port] the heap is used up\n");
    errno = ENOMEM;
    return reinterpret_cast<void*>(-1);
  }
  heap_end += bytes;
  return block;
}

int _write(int, const char* text, int length) {
  const uintptr_t block[3] = {standard_output(), reinterpret_cast<uintptr_t>(text),
                              static_cast<uintptr_t>(length)};
  const int32_t not_written = port::call_host(port::HostCall::write, block);
  return length - not_written;
}

int _gettimeofday(struct timeval* time, void*) {
  const int32_t centiseconds = port::call_host(port::HostCall::clock, nullptr);
  time->tv_sec = centiseconds / 100;
  time->tv_usec = (centiseconds % 100) * 10000;
  return 0;
}

[[noreturn]] void _exit(int status) {
  port::exit_program(status);
}

int _fstat(int, struct stat* status) {
  status->st_mode = S_IFCHR;
  return 0;
}

int _isatty(int) {
  return 0;
}

int _getpid() {
  return 1;
}

int _kill(int, int) {
  return fail(EINVAL);
}

int _read(int, char*, int) {
  return 0;
}

int _lseek(int, int, int) {
  return 0;
}

int _close(int) {
  return fail(EBADF);
}

int _open(const char*, int, int) {
  return fail(ENOENT);
}

int _unlink(const char*) {
  return fail(ENOENT);
}

int _link(const char*, const char*) {
  return fail(ENOENT);
}

clock_t _times(struct tms*) {
  return static_cast<clock_t>(-1);
}
}
