// Firmware that trusts neither its memory nor its arithmetic. At start it checks both before the
// first query; then it checks a slice of its memory in each period.
#include <flashbvh/self_test.hpp>

#include "../quick_start/query.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

/// Bytes per period, in 10,000 instructions: at 1 kHz, 512 KB of flash take half a second.
constexpr size_t kSlice = 1000;

/// The peg's height above the plate in cells: a variable, whose initial value lies in flash.
int32_t height = cells(0.5);

RegionTest memory(sealed_regions(), kSealedRegions);

/// The name of the first failed test; nullptr if all tests passed.
const char* failed_at_start() {
  return memory.run(SIZE_MAX) != Status::done ? "memory"
         : test_known_pairs() != Status::done ? "pairs"
         : test_known_rays() != Status::done  ? "rays"  // and tests of points inside
                                              : nullptr;
}

/// The machine's work in a period.
bool is_free() {
  return !touches(height);
}

}  // namespace

int main() {
  if (const char* const failed = failed_at_start()) {
    port::print("refused to start: ", failed, ", region ", memory.region(), "\n");
    return 1;
  }
  port::print("self-test passed, 0.5 mm above the plate: ", is_free() ? "free" : "touches", "\n");
  int periods = 1;
  Status status = Status::suspended;
  for (; (status = memory.run(kSlice)) == Status::suspended; ++periods) {
    height -= 1;
    if (!is_free()) {
      return 1;
    }
  }
  port::print("all memory checked again in ", periods,
              " periods: ", status == Status::done ? "good" : "damaged", "\n");
  return status == Status::done ? 0 : 1;
}
