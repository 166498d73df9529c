// One number for thousands of queries: every pair reported, in its order, every count, and under
// one rule where each pair intersects.
#pragma once

#include <stdint.h>

namespace digest {

/// FNV-1a over 32-bit words, 64 bits.
class Hash {
 public:
  void add(uint32_t word) {
    for (int i = 0; i < 4; ++i) {
      value_ = (value_ ^ (word & 0xFFu)) * 0x100000001B3u;
      word >>= 8;
    }
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xCBF29CE484222325u;
};

struct Result {
  uint64_t value;
  uint64_t distances;  ///< another value: of queries about distance
  uint64_t rays;       ///< the same of rays, and of points inside
  uint32_t cases;      ///< (mesh pair, pose, rule)
  uint32_t pairs;      ///< of triangles that intersect, over all cases
  uint32_t refused;    ///< trees that check_tree() does not accept: 0
};

/// Runs the fixed list of cases. About 7 KB of memory, all of it static.
Result run();

/// What every core and every compiler must get.
constexpr uint64_t kExpected = 0xFF21B5D96DE2C50Bu;
constexpr uint64_t kExpectedDistances = 0x9F9D28F1E08022E9u;
constexpr uint64_t kExpectedRays = 0x1BC7A7B50DE8E882u;

}  // namespace digest
