// Instructions and stack of a contact, counted on the target, by kind of pair.
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdio>
#include <new>

#include "flashbvh/contact.hpp"
#include "insn.hpp"
#include "stack.hpp"
#include "support/random.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace {

constexpr int kPairs = 300;

// RISC-V adds 64-bit numbers in more instructions.
#if defined(__riscv)
constexpr std::uint32_t kMostGeneral = 2200;
constexpr std::uint32_t kMostOthers = 10000;
#else
constexpr std::uint32_t kMostGeneral = 2000;
constexpr std::uint32_t kMostOthers = 9000;
#endif

struct Cost {
  std::uint32_t most;
  std::uint32_t stack;
};

/// The most over some hundred pairs of a kind that intersect; printed with the mean.
template <class Make>
Cost cost_of(const char* kind, Make make) {
  test::Random random = test::test_random();
  Cost cost = {0, 0};
  std::uint32_t sum = 0;
  for (int i = 0; i < kPairs;) {
    const test::TransformedPair pair = make(random);
    if (!triangles_intersect(pair.a, pair.b)) {
      continue;
    }
    ++i;
    Contact contact;
    // In its place, as a caller's variable is.
    const auto ask = [&] { ::new (&contact) Contact(contact_of(pair.a, pair.b)); };
    const std::uint32_t count = port::instructions_of(ask);
    const std::uint32_t stack = port::stack_of(ask);
    cost.most = count > cost.most ? count : cost.most;
    cost.stack = stack > cost.stack ? stack : cost.stack;
    sum += count;
  }
  std::printf("contact, %-14s %5u instructions at most, %5u on average, %u bytes of stack\n", kind,
              static_cast<unsigned>(cost.most), static_cast<unsigned>(sum / kPairs),
              static_cast<unsigned>(cost.stack));
  std::fflush(stdout);
  return cost;
}

test::TransformedPair without_area(test::Random& random) {
  for (;;) {
    const test::TransformedPair pair = test::any_pair(random);
    if (triangles_intersect(pair.a, pair.b) &&
        contact_of(pair.a, pair.b).kind == ContactKind::degenerate) {
      return pair;
    }
  }
}

}  // namespace

TEST_CASE("instructions and stack of a contact stay within what the header says") {
  const Cost general = cost_of("general", [](test::Random& random) {
    return test::TransformedPair{
        {{test::point_within(random, 30000), test::point_within(random, 30000),
          test::point_within(random, 30000)}},
        {{test::point_within(random, 30000), test::point_within(random, 30000),
          test::point_within(random, 30000)}}};
  });
  const Cost coplanar =
      cost_of("coplanar", [](test::Random& random) { return test::coplanar_pair(random, 30000); });
  const Cost degenerate = cost_of("degenerate", without_area);
  CHECK(general.most <= kMostGeneral);
  CHECK(coplanar.most <= kMostOthers);
  CHECK(degenerate.most <= kMostOthers);
  CHECK(general.stack <= 280);
  CHECK(coplanar.stack <= 280);
  CHECK(degenerate.stack <= 280);
}
