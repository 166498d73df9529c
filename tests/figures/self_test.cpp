// The costs of self-tests: known answers, and constant memory per byte.
#include "flashbvh/self_test.hpp"

#include "flashbvh/robot/self_test.hpp"
#include "report.hpp"

using namespace flashbvh;

namespace {

constexpr uint32_t kBytes = 4096;
uint8_t memory[kBytes];

bool passes(const char* name, Status (*test)()) {
  Status status = Status::self_test_failed;
  figures::measure({{"self_test", name}}, [&] { status = test(); });
  return status == Status::done;
}

bool checks_memory() {
  const MemoryRegion region = region_of(memory, kBytes);
  RegionTest test(&region, 1);
  Status status = Status::self_test_failed;
  const uint32_t instructions = port::instructions_of([&] { status = test.run(kBytes); });
  figures::add_quotient({{"self_test", "byte"}}, instructions, kBytes);
  return status == Status::done;
}

}  // namespace

int main() {
  bool good = passes("pairs", test_known_pairs);
  good = passes("distances", test_known_distances) && good;
  good = passes("rays", test_known_rays) && good;
  good = passes("guard", test_known_guard) && good;
  good = checks_memory() && good;
  return figures::print_all("self_test", good);
}
