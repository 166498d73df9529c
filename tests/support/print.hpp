// Output of programs that run on the host and, without stdio, on boards.
#pragma once

#include <stdint.h>

#if defined(FLASHBVH_ON_BOARD)
#include "text.hpp"
#else
#include <iostream>
#endif

namespace flashbvh::test {

#if defined(FLASHBVH_ON_BOARD)
using port::print;
#else
template <class... Values>
void print(const Values&... values) {
  (std::cout << ... << values);
}
#endif

/// All hexadecimal digits of a number.
template <class Number>
struct Hexadecimal {
  explicit Hexadecimal(Number value) {
    for (unsigned i = 0; i < kDigits; ++i) {
      text[i] = "0123456789ABCDEF"[(value >> (4 * (kDigits - 1 - i))) & 15u];
    }
    text[kDigits] = 0;
  }

  static constexpr unsigned kDigits = 2 * sizeof(Number);
  char text[kDigits + 1];
};

}  // namespace flashbvh::test
