// Packed boxes and the overlap test, against plain integers.
#include <catch2/catch.hpp>

#include <cstdint>
#include <initializer_list>

#include "flashbvh/detail/bounds/box.hpp"
#include "support/points.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr std::int32_t kMost = kMaxCoordinate;

bool overlap_1d(std::int32_t low_a, std::int32_t high_a, std::int32_t low_b, std::int32_t high_b,
                std::int64_t t) {
  return low_a <= high_b + t && low_b + t <= high_a;
}

bool overlap(const Box& a, const Box& b, std::int32_t x, std::int32_t y, std::int32_t z) {
  return overlap_1d(a.lower.x, a.upper.x, b.lower.x, b.upper.x, x) &&
         overlap_1d(a.lower.y, a.upper.y, b.lower.y, b.upper.y, y) &&
         overlap_1d(a.lower.z, a.upper.z, b.lower.z, b.upper.z, z);
}

/// A coordinate near zero, near the lattice's ends, or anywhere.
std::int16_t coordinate(Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<std::int16_t>(random.between(-3, 3));
    case 1:
      return static_cast<std::int16_t>(kMost - random.between(0, 2));
    case 2:
      return static_cast<std::int16_t>(-kMost + random.between(0, 2));
    default:
      return static_cast<std::int16_t>(random.between(-kMost, kMost));
  }
}

Box box(Random& random) {
  const auto sorted = [&](std::int16_t& low, std::int16_t& high) {
    const std::int16_t a = coordinate(random);
    const std::int16_t b = coordinate(random);
    low = a < b ? a : b;
    high = a < b ? b : a;
  };
  Box box{};
  sorted(box.lower.x, box.upper.x);
  sorted(box.lower.y, box.upper.y);
  sorted(box.lower.z, box.upper.z);
  return box;
}

std::int32_t translation(Random& random) {
  constexpr std::int32_t ends[] = {0, 1, -1, 32765, 32766, 32767, 32768, 32769, 65535, 65536};
  const std::int32_t end = ends[random.below(10)];
  switch (random.below(4)) {
    case 0:
      return end;
    case 1:
      return -end;
    case 2:
      return random.between(-40000, 40000);
    default:
      const auto far = (1 << 30) - static_cast<std::int32_t>(random.below(3));
      return random.below(2) == 0 ? -far : far;
  }
}

}  // namespace

TEST_CASE("packing a box loses nothing") {
  Random random = test_random();
  for (int round = 0; round < 10000; ++round) {
    const Box original = box(random);
    const PackedBox packed = pack(original);
    const Box back = unpack(packed);
    REQUIRE(same(back, original));
    REQUIRE(extent_x(packed) == static_cast<std::uint32_t>(original.upper.x - original.lower.x));
    REQUIRE(extent_y(packed) == static_cast<std::uint32_t>(original.upper.y - original.lower.y));
    REQUIRE(extent_z(packed) == static_cast<std::uint32_t>(original.upper.z - original.lower.z));
  }
}

TEST_CASE("packed boxes overlap exactly when the boxes do, at every translation") {
  Random random = test_random();
  int overlaps = 0;
  for (int round = 0; round < 100000; ++round) {
    const Box a = box(random);
    const Box b = box(random);
    const std::int32_t x = random.below(2) == 0 ? 0 : translation(random);
    const std::int32_t y = random.below(2) == 0 ? 0 : translation(random);
    const std::int32_t z = random.below(2) == 0 ? 0 : translation(random);
    const bool expected = overlap(a, b, x, y, z);
    overlaps += expected ? 1 : 0;
    const TranslatedBoxTest test(x, y, z);
    const BoxInNode of_a = in_node(random, a);
    const BoxInNode of_b = in_node(random, b);
    const bool fast = test(of_a.box, of_b.box);
    const bool reference = test.portable(of_a.box, of_b.box);
    if (fast != expected || reference != expected) {
      CAPTURE(round, x, y, z);
      REQUIRE(fast == expected);
      REQUIRE(reference == expected);
    }
  }
  CHECK(overlaps > 1000);
}

TEST_CASE("boxes that touch overlap, and a cell further they do not") {
  const PackedBox unit = pack({{0, 0, 0}, {1, 1, 1}});
  for (const std::int32_t t : {-1, 1}) {
    CHECK(TranslatedBoxTest(t, 0, 0)(unit, unit));
    CHECK(TranslatedBoxTest(0, t, 0)(unit, unit));
    CHECK(TranslatedBoxTest(0, 0, t)(unit, unit));
    CHECK_FALSE(TranslatedBoxTest(2 * t, 0, 0)(unit, unit));
    CHECK_FALSE(TranslatedBoxTest(0, 2 * t, 0)(unit, unit));
    CHECK_FALSE(TranslatedBoxTest(0, 0, 2 * t)(unit, unit));
  }
}

TEST_CASE("all forms of the packed comparison are one function") {
  Random random = test_random();
  const auto half = [&] {
    constexpr std::uint32_t ends[] = {0, 1, 0x7FFF, 0x8000, 0x8001, 0xFFFE, 0xFFFF};
    return random.below(2) == 0 ? ends[random.below(7)] : random.below(0x10000);
  };
  for (int round = 0; round < 100000; ++round) {
    PackedTriple value{};
    PackedTriple least{};
    for (int i = 0; i < 3; ++i) {
      value.word[i] = join_halves(half(), half());
      least.word[i] = random.below(2) == 0 ? value.word[i] : join_halves(half(), half());
    }
    const bool reference = halves_reach_portable(value, least);
    if (halves_reach_plain(value, least) != reference || halves_reach(value, least) != reference) {
      CAPTURE(round);
      REQUIRE(halves_reach_plain(value, least) == reference);
      REQUIRE(halves_reach(value, least) == reference);
    }
  }
}
