// The linker sends every call of malloc and its kin here (--wrap). Natively operator new lives in a
// shared library that it does not touch, so there it is replaced by one that calls malloc.
#include "heap_guard.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

int scopes = 0;

void refuse_inside_scope() {
  if (scopes == 0) {
    return;
  }
  scopes = 0;  // so that the message may allocate
  std::puts("heap used while HeapForbidden");
  std::fflush(stdout);
  std::_Exit(122);
}

}  // namespace

HeapForbidden::HeapForbidden() {
  ++scopes;
}

HeapForbidden::~HeapForbidden() {
  --scopes;
}

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* block, std::size_t size);

void* __wrap_malloc(std::size_t size) {
  refuse_inside_scope();
  return __real_malloc(size);
}

void* __wrap_calloc(std::size_t count, std::size_t size) {
  refuse_inside_scope();
  return __real_calloc(count, size);
}

void* __wrap_realloc(void* block, std::size_t size) {
  refuse_inside_scope();
  return __real_realloc(block, size);
}

#if defined(__NEWLIB__) || defined(_NEWLIB_VERSION)
// newlib's own functions allocate through this one.
struct _reent;
void* __real__malloc_r(struct _reent* context, std::size_t size);

void* __wrap__malloc_r(struct _reent* context, std::size_t size) {
  refuse_inside_scope();
  return __real__malloc_r(context, size);
}
#endif
}

#if !defined(__NEWLIB__) && !defined(_NEWLIB_VERSION)
void* operator new(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) {
    std::abort();
  }
  return block;
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
#endif
