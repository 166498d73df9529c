// picolibc's system calls, for tests: picolibc's own semihosting does not support this core.
#include <signal.h>
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h>

#include "semihosting.hpp"

namespace {

int put_character(char character, FILE*) {
  const char text[] = {character, '\0'};
  port::call_host(port::HostCall::write0, text);
  return 0;
}

FILE standard_output = FDEV_SETUP_STREAM(put_character, nullptr, nullptr, _FDEV_SETUP_WRITE);

}  // namespace

FILE* const stdin = &standard_output;
FILE* const stdout = &standard_output;
FILE* const stderr = &standard_output;

extern "C" {
[[noreturn]] void _exit(int status) {
  port::exit_program(status);
}
pid_t getpid() {
  return 1;
}
int kill(pid_t, int) {
  return -1;
}
}
