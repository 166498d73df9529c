// Random numbers, the same on every machine.
#pragma once

#include <cstdint>

namespace flashbvh::tool {

/// The splitmix64 generator (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014), with a fixed start.
class Random {
 public:
  /// A number from -most to most.
  std::int64_t within(std::int64_t most) {
    const auto count = static_cast<std::uint64_t>(2 * most + 1);
    return static_cast<std::int64_t>(((next() >> 32) * count) >> 32) - most;
  }

  /// A number from 0 to below 1.
  double part() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t next() {
    std::uint64_t bits = (state_ += 0x9E3779B97F4A7C15u);
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
  }

  std::uint64_t state_ = 1;
};

}  // namespace flashbvh::tool
