// One number for thousands of queries: every reported pair, in order, every count, and, with one
// traversal, each pair's contact.
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
  bool is_expected;  ///< whether all sums have the expected values
  uint32_t cases;    ///< (mesh pair, pose, rule)
  uint32_t pairs;    ///< of triangles that intersect, over all cases
  uint32_t refused;  ///< trees that check_tree() refuses: 0
};

/// Receives a sum's name, its value, and the value of every core and compiler; returns whether they
/// are equal.
using Report = bool(const char* name, uint64_t value, uint64_t expected);

/// Runs the fixed list of cases. About 7 KB of memory, all of it static.
Result run(Report* report);

}  // namespace digest
