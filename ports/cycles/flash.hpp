// Flash that is slower than the core: cycles added by reading instructions and data from it.
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
  uint32_t data_lines = 0;  ///< of the data cache; 0: data share the instruction cache
  uint32_t wait = 0;        ///< cycles of a line that is not in the cache
  uint32_t prefetches = 0;  ///< 1: the next line is read while a line is executed
};

/// A set-associative cache with least-recently-used replacement.
class LineCache {
 public:
  LineCache(uint32_t sets, uint32_t ways) : sets_(sets), ways_(ways) {}
  /// Returns whether `line` was in the cache, and puts it there.
  bool use(uint64_t line);
  bool has(uint64_t line) const;

 private:
  std::vector<std::deque<uint64_t>> sets_;
  uint32_t ways_;
};

class Flash {
 public:
  /// Returns an error of `name` or of tables/flash.csv; empty if there is none.
  static std::string read(const std::string& path, const std::string& name, FlashProfile& profile);

  Flash(const FlashProfile& profile, uint64_t begin, uint64_t bytes);

  bool holds(uint64_t address) const { return address - begin_ < bytes_; }
  /// Returns the cycles waited for the code at [first, after), which takes `cycles` from `now` on.
  uint64_t fetch(uint64_t first, uint64_t after, uint64_t now, uint64_t cycles);
  uint64_t load(uint64_t address);

 private:
  uint64_t fetch_line(uint64_t line, uint64_t now);

  FlashProfile profile_;
  uint64_t begin_;
  uint64_t bytes_;
  LineCache instructions_;
  LineCache data_;
  uint64_t line_ = ~uint64_t{0};  ///< of the last instruction fetch
  uint64_t prefetched_ = ~uint64_t{0};
  uint64_t prefetch_ends_ = 0;
};

}  // namespace cycles
