// main() of the small header's own tests on this machine, and what they need of a port.
#include <cstdio>
#include <cstdlib>

#include "assertion.hpp"
#include "test_case.hpp"

namespace port {

void put(const char* text) {
  std::fputs(text, stdout);
}
void put(int value) {
  std::printf("%d", value);
}
void put(unsigned value) {
  std::printf("%u", value);
}
void put(long value) {
  std::printf("%ld", value);
}
void put(unsigned long value) {
  std::printf("%lu", value);
}
void put(long long value) {
  std::printf("%lld", value);
}
void put(unsigned long long value) {
  std::printf("%llu", value);
}

}  // namespace port

namespace small_catch {

void stop() {
  std::exit(120);  // as on a board
}

}  // namespace small_catch

int main(int argc, char** argv) {
  return small_catch::run(argc, argv);
}
