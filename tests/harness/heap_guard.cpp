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

// The linker's --wrap=malloc turns a reference to malloc into one to __wrap_malloc, and one to
// __real_malloc into one to malloc.
#define FLASHBVH_WRAP(name, parameters, arguments) \
  void* __real_##name parameters;                  \
  void* __wrap_##name parameters {                 \
    refuse_inside_scope();                         \
    return __real_##name arguments;                \
  }

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" {
FLASHBVH_WRAP(malloc, (std::size_t size), (size))
FLASHBVH_WRAP(calloc, (std::size_t count, std::size_t size), (count, size))
FLASHBVH_WRAP(realloc, (void* block, std::size_t size), (block, size))
// operator new and new[], plain and nothrow: they live in a shared library, whose own
// calls of malloc the linker cannot divert.
FLASHBVH_WRAP(_Znwm, (std::size_t size), (size))
FLASHBVH_WRAP(_Znam, (std::size_t size), (size))
FLASHBVH_WRAP(_ZnwmRKSt9nothrow_t, (std::size_t size, const std::nothrow_t& tag), (size, tag))
FLASHBVH_WRAP(_ZnamRKSt9nothrow_t, (std::size_t size, const std::nothrow_t& tag), (size, tag))
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
