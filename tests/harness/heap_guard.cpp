// The linker sends every call of malloc and its kin here: --wrap=malloc turns a reference to malloc
// into one to __wrap_malloc, and one to __real_malloc into one to malloc.
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

// The linker's names, by --wrap.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
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

#if defined(_NEWLIB_VERSION) && !defined(__PICOLIBC__)
// Where newlib's own functions and the static libstdc++ allocate.
struct _reent;
void* __real__malloc_r(struct _reent* context, std::size_t size);

void* __wrap__malloc_r(struct _reent* context, std::size_t size) {
  refuse_inside_scope();
  return __real__malloc_r(context, size);
}
#elif !defined(__PICOLIBC__)
// operator new and new[], plain and nothrow: natively they live in a shared library whose own calls
// of malloc the linker cannot divert.
void* __real__Znwm(std::size_t size);
void* __real__Znam(std::size_t size);
void* __real__ZnwmRKSt9nothrow_t(std::size_t size, const std::nothrow_t& tag);
void* __real__ZnamRKSt9nothrow_t(std::size_t size, const std::nothrow_t& tag);

void* __wrap__Znwm(std::size_t size) {
  refuse_inside_scope();
  return __real__Znwm(size);
}

void* __wrap__Znam(std::size_t size) {
  refuse_inside_scope();
  return __real__Znam(size);
}

void* __wrap__ZnwmRKSt9nothrow_t(std::size_t size, const std::nothrow_t& tag) {
  refuse_inside_scope();
  return __real__ZnwmRKSt9nothrow_t(size, tag);
}

void* __wrap__ZnamRKSt9nothrow_t(std::size_t size, const std::nothrow_t& tag) {
  refuse_inside_scope();
  return __real__ZnamRKSt9nothrow_t(size, tag);
}
#endif
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
