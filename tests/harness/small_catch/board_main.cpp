// main() of every test executable on a board.
#include "semihosting.hpp"
#include "small_catch.hpp"
#include "stack.hpp"

namespace small_catch {

void stop() {
  port::exit_program(port::kExitCatchWouldThrow);
}

}  // namespace small_catch

int main(int argc, char** argv) {
  const int failures = small_catch::run(argc, argv);
  // Few of these boards fault when the stack overflows. The last words may never have been written:
  // a frame need not fill itself.
  if (port::stack_used() == port::stack_size()) {
    port::put("the stack overflowed\n");
    return 1;
  }
  return failures;
}
