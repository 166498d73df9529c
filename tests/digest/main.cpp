// Prints the digest; exits with 0 if it is the one of every core and compiler.
#include "digest.hpp"

#include "support/print.hpp"

#if defined(FLASHBVH_ON_BOARD)
#include "stack.hpp"
#endif

using flashbvh::test::Hexadecimal;
using flashbvh::test::print;

namespace {

bool is_expected(const char* name, uint64_t value, uint64_t expected) {
  print(name, " 0x", Hexadecimal(value).text);
  if (value != expected) {
    print(", expected 0x", Hexadecimal(expected).text);
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
