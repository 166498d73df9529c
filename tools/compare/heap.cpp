// Replaces malloc() and its relatives, which all libraries call, to count allocations.
#include "comparison.hpp"

#include <malloc.h>

namespace {

compare::Heap counted{};
bool counts = false;

void* held(void* block) {
  if (counts) {
    ++counted.allocations;
    counted.bytes += malloc_usable_size(block);
  }
  return block;
}

void given_back(void* block) {
  if (counts) {
    counted.bytes -= malloc_usable_size(block);
  }
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) {
  return held(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) {
  return held(__libc_calloc(count, size));
}
void* realloc(void* block, std::size_t size) {
  given_back(block);
  return held(__libc_realloc(block, size));
}
void* memalign(std::size_t alignment, std::size_t size) {
  return held(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = memalign(alignment, size);
  return *block == nullptr ? 12 : 0;
}
void free(void* block) {
  given_back(block);
  __libc_free(block);
}

}  // extern "C"

namespace compare {

void count_heap() {
  counted = {};
  counts = true;
}

Heap counted_heap() {
  counts = false;
  return counted;
}

}  // namespace compare
