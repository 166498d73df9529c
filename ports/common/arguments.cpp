// The arguments of main(), from the host's command line: "<program> <text of -append>".
// Words end at blanks; "..." groups; a backslash escapes the next character.
#include <stddef.h>

#include "semihosting.hpp"
#include "start.hpp"

namespace port {
namespace {

constexpr size_t kLongestLine = 1024;
constexpr int kMostArguments = 31;

// Unquotes the word that starts at `source`, in place; returns a pointer to the text after it.
char* end_word(char* source) {
  char* target = source;
  bool quoted = false;
  for (; *source != '\0' && (quoted || *source != ' '); ++source) {
    if (*source == '"') {
      quoted = !quoted;
      continue;
    }
    if (*source == '\\' && source[1] != '\0') {
      ++source;
    }
    *target++ = *source;
  }
  char* const next = *source == '\0' ? source : source + 1;
  *target = '\0';
  return next;
}

}  // namespace

int read_arguments(char*** argv) {
  static char line[kLongestLine];
  static char* words[kMostArguments + 1];
  struct {
    char* text;
    uintptr_t length;
  } block = {line, sizeof line - 1};
  if (call_host(HostCall::get_command_line, &block) != 0) {
    line[0] = '\0';
  }
  int count = 0;
  for (char* rest = line; count < kMostArguments;) {
    while (*rest == ' ') {
      ++rest;
    }
    if (*rest == '\0') {
      break;
    }
    words[count++] = rest;
    rest = end_word(rest);
  }
  *argv = words;
  return count;
}

}  // namespace port
