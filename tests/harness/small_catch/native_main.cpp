// main() of the small header's own tests on this machine.
#include <cstdlib>

#include "assertion.hpp"
#include "test_case.hpp"

namespace small_catch {

void stop() {
  std::exit(120);  // as on a board
}

}  // namespace small_catch

int main(int argc, char** argv) {
  return small_catch::run(argc, argv);
}
