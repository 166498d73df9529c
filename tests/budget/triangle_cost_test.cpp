// Instructions of the exact triangle test, counted on the target, by kind of pair.
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstdio>

#include "flashbvh/triangle.hpp"
#include "insn.hpp"
#include "support/random.hpp"

using namespace flashbvh;

namespace {

constexpr int kPairs = 300;

struct Pair {
  PlacedTriangle a;
  PlacedTriangle b;
};

Point near_zero(test::Random& random, std::int32_t reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}

/// Random corners, then made what the kind is about.
template <class Adapt>
Pair random_pair(test::Random& random, Adapt adapt) {
  constexpr std::int32_t kReach = 8000;  // differences below 2^15
  Pair pair{};
  for (int i = 0; i < 3; ++i) {
    pair.a.corner[i] = near_zero(random, kReach);
    pair.b.corner[i] = near_zero(random, kReach);
  }
  adapt(pair);
  return pair;
}

/// The most over some hundred pairs of a kind; printed with the mean.
template <class Adapt>
std::uint32_t most_instructions(const char* kind, Adapt adapt) {
  test::Random random(test::test_seed());
  std::uint32_t most = 0;
  std::uint32_t sum = 0;
  for (int i = 0; i < kPairs; ++i) {
    const Pair pair = random_pair(random, adapt);
    bool met = false;
    const std::uint32_t count =
        port::instructions_of([&] { met = triangles_intersect(pair.a, pair.b); });
    most = count > most ? count : most;
    sum += count;
  }
  std::printf("%-16s %5u instructions at most, %5u on average\n", kind, static_cast<unsigned>(most),
              static_cast<unsigned>(sum / kPairs));
  return most;
}

}  // namespace

TEST_CASE("instructions of a triangle pair stay within what the header says") {
  const std::uint32_t apart = most_instructions("boxes apart", [](Pair& pair) {
    for (Point& corner : pair.b.corner) {
      corner.z += 16001;
    }
  });
  const std::uint32_t general = most_instructions("general", [](Pair&) {});
  const std::uint32_t coplanar = most_instructions("coplanar", [](Pair& pair) {
    for (int i = 0; i < 3; ++i) {
      pair.a.corner[i].z = pair.a.corner[i].x + pair.a.corner[i].y;
      pair.b.corner[i].z = pair.b.corner[i].x + pair.b.corner[i].y;
    }
  });
  const std::uint32_t segments = most_instructions("two segments", [](Pair& pair) {
    pair.a.corner[2] = pair.a.corner[1];
    pair.b.corner[2] = pair.b.corner[1];
  });
  std::fflush(stdout);
  CHECK(apart <= 150);
  CHECK(general <= 550);
  CHECK(coplanar <= 1800);
  CHECK(segments <= 2800);
}
