// Instructions of the exact triangle test and of a contact, and a contact's stack, counted on the
// target, by kind of pair.
#include <catch2/catch.hpp>

#include <stdint.h>

#include <new>

#include "flashbvh/contact.hpp"
#include "insn.hpp"
#include "stack.hpp"
#include "support/print.hpp"
#include "support/triangle_kinds.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr int kPairs = 300;

// RISC-V needs more instructions to add 64-bit numbers.
#if defined(__riscv)
constexpr uint32_t kMostOfTest = 600;
constexpr uint32_t kMostGeneral = 2200;
constexpr uint32_t kMostOthers = 10000;
#else
constexpr uint32_t kMostOfTest = 550;
constexpr uint32_t kMostGeneral = 2000;
constexpr uint32_t kMostOthers = 9000;
#endif

/// The maximum over some hundred pairs of a kind; prints it with the mean.
template <class Make, class Run>
void check_cost(const char* what, uint32_t most_allowed, Make make, Run run) {
  Random random = test_random();
  uint32_t most = 0;
  uint32_t sum = 0;
  for (int i = 0; i < kPairs; ++i) {
    const TransformedPair pair = make(random);
    const uint32_t count = port::instructions_of([&] { run(pair); });
    most = count > most ? count : most;
    sum += count;
  }
  print("budget: ", what, ": ", most, " instructions at most, ", sum / kPairs, " on average\n");
  CHECK(most <= most_allowed);
}

void check_test(const TriangleKind& kind, uint32_t most) {
  const auto make = [&kind](Random& random) {
    TransformedPair pair;
    set_random_pair(random, kind, pair.a, pair.b);
    return pair;
  };
  bool intersecting = false;
  check_cost(kind.name, most, make, [&](const TransformedPair& pair) {
    intersecting = triangles_intersect(pair.a, pair.b);
  });
}

/// For pairs that intersect.
template <class Make>
void check_contact(const char* kind, uint32_t most, Make make) {
  uint32_t stack = 0;
  const auto make_intersecting = [&](Random& random) {
    for (;;) {
      const TransformedPair pair = make(random);
      if (triangles_intersect(pair.a, pair.b)) {
        return pair;
      }
    }
  };
  Contact contact;
  // Constructs it in place, like a caller's variable.
  const auto run = [&](const TransformedPair& pair) {
    ::new (&contact) Contact(contact_of(pair.a, pair.b));
  };
  check_cost(kind, most, make_intersecting, run);
  Random random = test_random();
  for (int i = 0; i < kPairs; ++i) {
    const TransformedPair pair = make_intersecting(random);
    const uint32_t bytes = port::stack_of([&] { run(pair); });
    stack = bytes > stack ? bytes : stack;
  }
  print("budget: ", kind, ": ", stack, " bytes of stack\n");
  CHECK(stack <= 280);
}

}  // namespace

TEST_CASE("instructions of a triangle pair stay within what the header says") {
  check_test(kBoxesDisjoint, 150);
  check_test(kGeneral, kMostOfTest);
  check_test(kCoplanar, 1800);
  check_test(kSegments, 2800);
}

TEST_CASE("instructions and stack of a contact stay within what the header says") {
  check_contact("contact, general", kMostGeneral, [](Random& random) {
    const auto any = [&] { return point_within(random, 30000); };
    return TransformedPair{{{any(), any(), any()}}, {{any(), any(), any()}}};
  });
  check_contact("contact, coplanar", kMostOthers,
                [](Random& random) { return coplanar_pair(random, 30000); });
  check_contact("contact, degenerate", kMostOthers, [](Random& random) {
    TransformedPair pair = any_pair(random);
    while (!triangles_intersect(pair.a, pair.b) ||
           contact_of(pair.a, pair.b).kind != ContactKind::degenerate) {
      pair = any_pair(random);
    }
    return pair;
  });
}
