// Firmware that trusts neither its memory nor its arithmetic: at start it checks all of it before
// the first query, and then a slice of its memory each period.
#include <flashbvh/self_test.hpp>

#include "../quick_start/query.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

/// Bytes a period: 10,000 instructions; at 1 kHz 512 KB of flash in half a second.
constexpr size_t kSlice = 1000;

/// Of the peg above the plate: a variable, whose initial value lies in flash.
int32_t height = cells(0.5);

RegionTest memory(sealed_regions(), kSealedRegions);

/// What of it failed; nullptr: nothing.
const char* failed_at_start() {
  return memory.run(SIZE_MAX) != Status::done ? "memory"
         : test_known_pairs() != Status::done ? "pairs"
         : test_known_rays() != Status::done  ? "rays"  // of points inside, too
                                              : nullptr;
}

/// The machine's work of a period.
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
