// What headers of the C++ library declare where there is no library behind them (Debian's RISC-V
// compiler): as much of it as the tests use. There are no exceptions: what would be thrown ends the
// program.
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

void __throw_bad_alloc() {
  end_with("bad_alloc");
}
void __throw_bad_array_new_length() {
  end_with("bad_array_new_length");
}
void __throw_bad_function_call() {
  end_with("bad_function_call");
}
void __throw_length_error(const char* what) {
  end_with(what);
}
void __throw_logic_error(const char* what) {
  end_with(what);
}
void __throw_out_of_range(const char* what) {
  end_with(what);
}
void __throw_out_of_range_fmt(const char* what, ...) {
  end_with(what);
}

// The header declares it to be elsewhere.
template class basic_string<char>;

}  // namespace std
