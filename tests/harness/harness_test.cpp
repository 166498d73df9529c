// The harness itself: names, values and the heap guard work the same natively and on a board.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <vector>

#include "heap_guard.hpp"

namespace {

// Without it the compiler removes an unused allocation.
void keep(void* block) {
  __asm__ volatile("" ::"r"(block) : "memory");
}

}  // namespace

TEST_CASE("a test name may have blanks, commas and <brackets>::of \"any\" kind") {
  CHECK(1 + 1 == 2);
}

TEMPLATE_TEST_CASE("templates run", "", short, long) {
  CHECK(sizeof(TestType) <= sizeof(long));
}

TEST_CASE("the heap guard lets code without a heap pass") {
  int sum = 0;
  {
    const HeapForbidden guard;
    for (int i = 0; i < 10; ++i) {
      sum += i;
    }
  }
  const std::vector<int> allowed_again(100, sum);
  CHECK(allowed_again.back() == 45);
}

// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks, clang-analyzer-unix.Malloc)
// Hidden: CMakeLists.txt runs each of these and expects the guard to end it.
TEST_CASE("allocate under the guard with new", "[.]") {
  {
    const HeapForbidden guard;
    keep(new int);
  }
  FAIL("new passed the guard");
}

TEST_CASE("allocate under the guard with array new", "[.]") {
  {
    const HeapForbidden guard;
    keep(new int[100]);
  }
  FAIL("array new passed the guard");
}

TEST_CASE("allocate under the guard with malloc", "[.]") {
  {
    const HeapForbidden guard;
    keep(std::malloc(4));
  }
  FAIL("malloc passed the guard");
}

TEST_CASE("allocate under the guard with calloc", "[.]") {
  {
    const HeapForbidden guard;
    keep(std::calloc(2, 4));
  }
  FAIL("calloc passed the guard");
}

TEST_CASE("allocate under the guard with realloc", "[.]") {
  void* const block = std::malloc(4);
  {
    const HeapForbidden guard;
    keep(std::realloc(block, 400));
  }
  FAIL("realloc passed the guard");
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks, clang-analyzer-unix.Malloc)
