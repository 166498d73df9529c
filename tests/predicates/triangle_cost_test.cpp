// Instructions of the exact triangle test, counted on the target, by kind of pair.
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdio>

#include "insn.hpp"
#include "support/triangle_kinds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace {

constexpr int kPairs = 300;

// RISC-V adds 64-bit numbers in more instructions.
#if defined(__riscv)
constexpr std::uint32_t kMostGeneral = 600;
#else
constexpr std::uint32_t kMostGeneral = 550;
#endif

/// The most over some hundred pairs of a kind; printed with the mean.
std::uint32_t most_instructions(const test::TriangleKind& kind) {
  test::Random random = test::test_random();
  std::uint32_t most = 0;
  std::uint32_t sum = 0;
  for (int i = 0; i < kPairs; ++i) {
    Triangle a;
    Triangle b;
    test::set_random_pair(random, kind, a, b);
    bool intersecting = false;
    const std::uint32_t count =
        port::instructions_of([&] { intersecting = triangles_intersect(a, b); });
    most = count > most ? count : most;
    sum += count;
  }
  std::printf("%-16s %5u instructions at most, %5u on average\n", kind.name,
              static_cast<unsigned>(most), static_cast<unsigned>(sum / kPairs));
  std::fflush(stdout);
  return most;
}

}  // namespace

TEST_CASE("instructions of a triangle pair stay within what the header says") {
  CHECK(most_instructions(test::kBoxesDisjoint) <= 150);
  CHECK(most_instructions(test::kGeneral) <= kMostGeneral);
  CHECK(most_instructions(test::kCoplanar) <= 1800);
  CHECK(most_instructions(test::kSegments) <= 2800);
}
