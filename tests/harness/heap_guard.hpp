// A scope in which no code may allocate.
#pragma once

/// While an object exists, malloc, calloc, realloc and operator new end the process with a message
/// and status 122, which fails the test. Freeing is allowed.
///
/// Catch2's own macros allocate: collect results inside the scope, check them after it.
class HeapForbidden {
 public:
  HeapForbidden();
  ~HeapForbidden();
  HeapForbidden(const HeapForbidden&) = delete;
  HeapForbidden& operator=(const HeapForbidden&) = delete;
};
