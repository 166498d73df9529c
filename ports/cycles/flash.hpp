// Flash that is slower than the core: the cycles that reading instructions and data from it adds.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace cycles {

/// A row of tables/flash.csv.
struct FlashProfile {
  uint32_t line_bytes = 0;
  uint32_t sets = 0;
  uint32_t ways = 0;
  uint32_t data_lines = 0;  ///< of a cache of its own; 0: data share that of instructions
  uint32_t wait = 0;        ///< cycles that a line which is not in the cache takes
  uint32_t prefetches = 0;  ///< 1: the next line is read while a line is executed
};

/// Sets of lines, of which the one used longest ago makes way.
class LineCache {
 public:
  LineCache(uint32_t sets, uint32_t ways) : sets_(sets), ways_(ways) {}
  /// Whether `line` was in the cache; afterwards it is.
  bool use(uint64_t line);
  bool has(uint64_t line) const;

 private:
  std::vector<std::deque<uint64_t>> sets_;
  uint32_t ways_;
};

class Flash {
 public:
  /// Returns what is wrong with `name`, or with tables/flash.csv; empty if nothing is.
  static std::string read(const std::string& path, const std::string& name, FlashProfile& profile);

  Flash(const FlashProfile& profile, uint64_t begin, uint64_t bytes);

  bool holds(uint64_t address) const { return address - begin_ < bytes_; }
  /// Cycles waited for the instructions at [first, after), which then take `cycles` from `now` on.
  uint64_t fetch(uint64_t first, uint64_t after, uint64_t now, uint64_t cycles);
  uint64_t load(uint64_t address);

 private:
  uint64_t fetch_line(uint64_t line, uint64_t now);

  FlashProfile profile_;
  uint64_t begin_;
  uint64_t bytes_;
  LineCache instructions_;
  LineCache data_;
  uint64_t line_ = ~uint64_t{0};  ///< that instructions were last fetched from
  uint64_t prefetched_ = ~uint64_t{0};
  uint64_t prefetch_ends_ = 0;
};

}  // namespace cycles
