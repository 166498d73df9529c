// What is allocated, by any library of this program.
#ifndef FLASHBVH_TOOLS_COMPARE_HEAP_HPP
#define FLASHBVH_TOOLS_COMPARE_HEAP_HPP

#include <cstddef>

namespace compare {

struct Heap {
  std::size_t allocations;
  std::size_t bytes;  ///< still held
};

/// From here on. Between, and in what is timed, nothing is counted.
void count_heap();
Heap counted_heap();

}  // namespace compare

#endif
