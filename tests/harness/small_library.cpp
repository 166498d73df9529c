// Definitions behind headers of the C++ library for a compiler without that library (Debian's
// RISC-V): only those that the tests use. There are no exceptions: a throw ends the program.
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

namespace {

[[noreturn]] void end_with(const char* what) {
  std::printf("the C++ library would throw: %s\n", what);
  std::abort();
}

void* allocate(std::size_t size) {
  void* const block = std::malloc(size != 0 ? size : 1);
  if (block == nullptr) {
    end_with("bad_alloc");
  }
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete[](void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  std::free(block);
}

namespace std {

#define FLASHBVH_THROWS(name) \
  void __throw_##name() {     \
    end_with(#name);          \
  }
#define FLASHBVH_THROWS_WHAT(name, ...)                  \
  void __throw_##name(const char* what, ##__VA_ARGS__) { \
    end_with(what);                                      \
  }
FLASHBVH_THROWS(bad_alloc)
FLASHBVH_THROWS(bad_array_new_length)
FLASHBVH_THROWS(bad_function_call)
FLASHBVH_THROWS_WHAT(length_error)
FLASHBVH_THROWS_WHAT(logic_error)
FLASHBVH_THROWS_WHAT(out_of_range)
FLASHBVH_THROWS_WHAT(out_of_range_fmt, ...)

// The header declares it extern.
template class basic_string<char>;

}  // namespace std
