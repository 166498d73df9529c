// Prints the digest; ends with 0 if it is the one that every core and compiler must get.
#include "digest.hpp"

#if defined(FLASHBVH_ON_BOARD)
#include "stack.hpp"
#include "text.hpp"
using port::print;
#else
#include <iostream>
namespace {
template <class... Values>
void print(const Values&... values) {
  (std::cout << ... << values);
}
}  // namespace
#endif

namespace {

/// 16 digits and a zero.
void put_hexadecimal(uint64_t value, char (&text)[17]) {
  for (int i = 0; i < 16; ++i) {
    text[i] = "0123456789ABCDEF"[(value >> (60 - 4 * i)) & 15u];
  }
  text[16] = 0;
}

bool is_expected(const char* name, uint64_t value, uint64_t expected) {
  char text[17];
  put_hexadecimal(value, text);
  print(name, " 0x", text);
  if (value != expected) {
    put_hexadecimal(expected, text);
    print(", expected 0x", text);
  }
  print("\n");
  return value == expected;
}

}  // namespace

int main() {
  const digest::Result result = digest::run(is_expected);
  print(result.cases, " queries found ", result.pairs, " pairs\n");
  if (result.refused != 0) {
    print(result.refused, " trees refused\n");
    return 2;
  }
  if (!result.is_expected) {
    return 1;
  }
#if defined(FLASHBVH_ON_BOARD)
  if (port::stack_used() >= port::stack_size()) {
    print("the stack of ", port::stack_size(), " bytes overflowed\n");
    return 3;
  }
#endif
  return 0;
}
