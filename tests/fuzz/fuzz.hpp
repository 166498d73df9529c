// Common parts of the fuzzed programs. Each defines LLVMFuzzerTestOneInput(), which libFuzzer
// calls, or replay.cpp if there is no libFuzzer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace flashbvh::test {

/// Ends the program unless `holds`: a finding.
inline void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "FOUND: %s\n", what);
    std::abort();
  }
}

/// Numbers from the front of the input; zeros after its end.
class Input {
 public:
  Input(const std::uint8_t* bytes, std::size_t size) : at_(bytes), left_(size) {}

  template <class Number>
  Number take() {
    Number number = 0;
    const std::size_t count = left_ < sizeof number ? left_ : sizeof number;
    if (count != 0) {
      std::memcpy(&number, at_, count);
    }
    at_ += count;
    left_ -= count;
    return number;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};

}  // namespace flashbvh::test
