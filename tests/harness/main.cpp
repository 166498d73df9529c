// main() of every test executable, natively and on the boards.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdio>

#if !defined(__cpp_exceptions)
#include <cstdlib>
#include <exception>

#include "semihosting.hpp"

// Where Catch2 cannot throw, a failed REQUIRE has been reported and ends the process: CTest runs a
// test case in each.
namespace Catch {
[[noreturn]] void throw_exception(const std::exception& exception) {
  std::printf("%s\n", exception.what());
  std::fflush(stdout);
  port::exit_program(port::kExitCatchWouldThrow);
}
}  // namespace Catch
#endif

int main(int argc, char** argv) {
  const int failures = Catch::Session().run(argc, argv);
  // The start-up code of a board leaves without closing anything.
  std::fflush(stdout);
  return failures;
}
